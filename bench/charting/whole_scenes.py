"""Whole scenes against POV-Ray and Tachyon: the same picture, one ray a pixel."""
import statistics

import numpy as np

from . import pictures, style, tables
from .programs import ROOT, Programs

NAME, TITLE = "whole_scenes", "Whole scenes, the same picture, one ray a pixel"
SCENES = ["S1", "S1n", "S2", "S3", "S3b", "S4"]
STRESS = {"S1": "primitives, two lights, a mirror", "S1n": "the same without tori",
          "S2": "200 tori", "S3": "sphereflake, 7381 balls", "S3b": "10 000 balls",
          "S4": "glass, eight deep"}


def run_of(context, program, scene, size):
    if program == "raytracer":
        return context.programs.raytracer(ROOT / f"bench/scenes/{scene}.lua", "-s",
                                          f"{size[0]}x{size[1]}", "--samples", "1")
    return getattr(context.programs, program)(scene, size)


def differing(run, own):
    """Share of pixels that differ by more than two 8-bit steps of the linear value."""
    far = np.abs(np.clip(run.picture, 0, 1) - np.clip(own.picture, 0, 1)).max(axis=2) > 2 / 255
    return float(far.mean())


def case_of(context, program, scene, size, own):
    def case():
        run = run_of(context, program, scene, size)
        seconds = run.stats.get("seconds", {})
        return {"scene": scene, "program": program, "size": f"{size[0]}x{size[1]}",
                "time": run.trace, "user": run.user, "wall": run.wall, "memory": run.memory,
                "script": seconds.get("script", ""), "plan": seconds.get("plan", ""),
                "write": seconds.get("write", ""),
                "rays": run.stats["rays"]["total"] if program == "raytracer"
                else run.stats.get("rays", ""),
                "differing": differing(run, own), "rmse": pictures.rmse(run.picture, own.picture)}
    return case


def programs_for(context, scene):
    yield "raytracer"
    if Programs.has("povray"):
        yield "povray"
    if Programs.has("tachyon") and (context.programs.peers / f"{scene}.tachyon.dat").exists():
        yield "tachyon"


def measure(context):
    size = (64, 48) if context.quick else (640, 480)
    scenes = SCENES[:2] if context.quick else SCENES
    cases = []
    for scene in [*scenes, "trivial"]:
        shape = (64, 48) if scene == "trivial" else size
        own = run_of(context, "raytracer", scene, shape)
        cases += [case_of(context, p, scene, shape, own) for p in programs_for(context, scene)]
    return {NAME: tables.alternated(cases, context.runs, "time", "user", "wall")}


def by_scene(rows):
    found = {}
    for row in rows:
        found.setdefault(row["scene"], {})[row["program"]] = row
    return found


def draw(data):
    figure, (axes,) = style.sheet(height=4.2)
    cases = {s: p for s, p in by_scene(data[NAME]).items() if s != "trivial"}
    names = list(cases)[::-1]
    for shift, program, colour, label in ((0.2, "povray", style.POVRAY, "POV-Ray"),
                                          (-0.2, "tachyon", style.TACHYON, "Tachyon")):
        for i, name in enumerate(names):
            if program not in cases[name]:
                continue
            own, peer = cases[name]["raytracer"], cases[name][program]
            ratio = peer["time"] / own["time"]
            bar = axes.barh(i + shift, ratio, 0.36, color=colour, label=label,
                            xerr=[[ratio - peer["time_min"] / own["time_max"]],
                                  [peer["time_max"] / own["time_min"] - ratio]],
                            error_kw={"elinewidth": 0.8, "capsize": 2})
            axes.bar_label(bar, [f"{ratio:.2f}"], padding=4, fontsize=8)
            label = None
    axes.axvline(1, color=style.OWN, linewidth=1.2)
    axes.set(yticks=range(len(names)), yticklabels=[f"{n}: {STRESS[n]}" for n in names],
             title=TITLE, xlabel="peer's trace time / ours (right of the line: we are faster)")
    axes.set_xlim(0, axes.get_xlim()[1] * 1.22)
    axes.grid(axis="y", visible=False)
    axes.legend(fontsize=8, loc="lower right")
    return figure, ("Processor time of tracing, start-up left out; one thread, programs in turns, "
                    f"medians of {data[NAME][0]['runs']:.0f} runs, whiskers: all pairs of runs. "
                    "Tachyon has no tori and no glass, "
                    "and samples half a pixel off; S4's checker is filtered "
                    "by this program only. Figures: bench/results/speed.md")


def line_of(scene, name, row, ratio, rays):
    compared = name != "raytracer" and scene != "trivial"
    cells = [scene, name, f"{row['time']:.3f} [{row['time_min']:.3f}, {row['time_max']:.3f}]",
             f"{ratio:.2f}" if compared else "", rays, f"{row['user']:.2f}",
             f"{row['memory'] / 1e6:.0f}", f"{100 * row['differing']:.2f}%" if compared else ""]
    return "| " + " | ".join(cells) + " |"


def report(data, heading):
    """bench/results/speed.md."""
    lines = ["# Speed against other ray tracers", "", *[f"{line}  " for line in heading], "",
             "Medians [least, largest] of runs in turns, one thread, one ray a pixel. Trace: "
             "processor time of tracing by each program's own statistics (Tachyon states wall time; "
             "where the process took less processor time than that, the latter). Differing: pixels "
             "more than 2/255 (linear) away from ours; Tachyon samples half a pixel off, so that "
             "edges and small things differ though the scene is the same; in S4 our checker is "
             "filtered over the pixel, POV-Ray's is not.", "",
             "| scene | program | trace, s | peer / ours | M rays/s | whole process, user s | memory, MB "
             "| differing |", "|---|---|---|---|---|---|---|---|"]
    ratios = {"povray": [], "tachyon": []}
    for scene, programs in by_scene(data[NAME]).items():
        for name, row in programs.items():
            ratio = row["time"] / max(programs["raytracer"]["time"], 1e-9)
            if name in ratios and scene != "trivial":
                ratios[name].append(ratio)
            rays = f"{row['rays'] / row['time'] / 1e6:.1f}" if row["rays"] and row["time"] else "-"
            lines.append(line_of(scene, name, row, ratio, rays))
    lines += ["", *[f"Median ratio to {n}: **{statistics.median(r):.2f}** over {len(r)} scenes.  "
                    for n, r in ratios.items() if r], "", "## Our phases, seconds by the clock", "",
              "| scene | script | plan | trace (processor) | write | whole process |",
              "|---|---|---|---|---|---|"]
    for scene, programs in by_scene(data[NAME]).items():
        r = programs["raytracer"]
        lines.append(f"| {scene} | {r['script']:.4f} | {r['plan']:.4f} | {r['time']:.3f} | "
                     f"{r['write']:.3f} | {r['wall']:.2f} |")
    lines += ["", "## Start-up: the trivial scene, 64x48", "",
              "| program | user s | wall s [least, largest] |", "|---|---|---|"]
    for name, r in by_scene(data[NAME])["trivial"].items():
        lines.append(f"| {name} | {r['user']:.3f} | {r['wall']:.3f} [{r['wall_min']:.3f}, "
                     f"{r['wall_max']:.3f}] |")
    lines += ["", "Ours is mostly the loading of OpenImageIO, which writes the picture. POV-Ray "
              "polls for its own end twice a second."]
    return "speed.md", "\n".join(lines) + "\n"
