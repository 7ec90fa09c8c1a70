"""Whole scenes against other ray tracers: the same picture, one ray a pixel; and soft shadows by the
same number of shadow rays. The table is in speed_table.py."""
import numpy as np

from . import pictures, speed_table, style, tables
from .programs import ROOT, Programs

NAME, TITLE = "whole_scenes", "Whole scenes, the same picture, one ray a pixel"
POINTS = "S4, point-sampled"
# What is rendered: the scene, our options, those of POV-Ray, and what it stresses.
ONE_RAY = ["--samples", "1"]
CASES = {"S1": ("S1", ONE_RAY, [], "primitives, two lights, a mirror"),
         "S1n": ("S1n", ONE_RAY, [], "the same without tori"),
         "S2": ("S2", ONE_RAY, [], "200 tori"),
         "S3": ("S3", ONE_RAY, [], "sphereflake, 7381 balls"),
         "S3b": ("S3b", ONE_RAY, [], "10 000 balls"),
         POINTS: ("S4", [*ONE_RAY, "--disable", "texture-filter"], [], "glass, eight deep"),
         "S4": ("S4", ONE_RAY, [], "the same, our checker filtered"),
         "S5, light a point": ("S5", [*ONE_RAY, "--disable", "soft-shadows"],
                               ["-A", "Declare=AN=1"], "a rectangular light as a point")}
# As many shadow rays a pixel; ours go with as many camera rays, POV-Ray's with one.
SOFT = {f"{scene}, 64 shadow rays": (scene, ["--samples", "64", "--filter", "box"],
                                     ["-A", "Declare=AN=8"], light)
        for scene, light in (("S5", "a rectangular light"), ("S5s", "a spherical light"))}
TRIVIAL = "trivial"
MITSUBA = {"S1", "S1n", "S2", "S3", "S3b"}  # those of which it makes the same picture
LABELS = {"povray": "POV-Ray", "tachyon": "Tachyon", "mitsuba": "Mitsuba"}
COLOURS = {"povray": style.POVRAY, "tachyon": style.TACHYON, "mitsuba": style.PINK}


def spec(name):
    return {**CASES, **SOFT, TRIVIAL: ("trivial", ONE_RAY, [], "")}[name]


def run_of(context, program, name, size):
    scene, own, pov, _ = spec(name)
    if program == "raytracer":
        return context.programs.raytracer(ROOT / f"bench/scenes/{scene}.lua", "-s",
                                          f"{size[0]}x{size[1]}", *own)
    if program == "povray":
        return context.programs.povray(scene, size, *pov)
    return getattr(context.programs, program)(scene, size)


def differing(run, own):
    """Share of pixels that differ by more than two 8-bit steps of the linear value."""
    far = np.abs(np.clip(run.picture, 0, 1) - np.clip(own.picture, 0, 1)).max(axis=2) > 2 / 255
    return float(far.mean())


def case_of(context, program, name, size, own):
    def case():
        run = run_of(context, program, name, size)
        seconds = run.stats.get("seconds", {})
        rays = run.stats.get("rays", "")
        return {"scene": name, "program": program, "size": f"{size[0]}x{size[1]}",
                "time": run.trace, "user": run.user, "wall": run.wall, "memory": run.memory,
                "script": seconds.get("script", ""), "plan": seconds.get("plan", ""),
                "write": seconds.get("write", ""), "load": run.stats.get("load", ""),
                "rays": rays["total"] if program == "raytracer" else rays,
                "differing": differing(run, own), "rmse": pictures.rmse(run.picture, own.picture)}
    return case


def programs_for(context, name):
    scene = spec(name)[0]
    yield "raytracer"
    if Programs.has("povray"):
        yield "povray"
    alike = name in (scene, TRIVIAL)  # no options of ours, none of theirs
    if alike and Programs.has("tachyon") and \
            (context.programs.peers / f"{scene}.tachyon.dat").exists():
        yield "tachyon"
    if name in MITSUBA | {TRIVIAL} and context.programs.mitsuba_python:
        yield "mitsuba"


def size_of(context, name):
    if name == TRIVIAL or context.quick:
        return 64, 48
    return (320, 240) if name in SOFT else (640, 480)


def measure(context):
    names = ["S1", "S1n", "S5, 64 shadow rays"] if context.quick else [*CASES, *SOFT]
    cases = []
    for name in [*names, TRIVIAL]:
        size = size_of(context, name)
        own = run_of(context, "raytracer", name, size)
        cases += [case_of(context, p, name, size, own) for p in programs_for(context, name)]
    return {NAME: tables.alternated(cases, context.runs, "time", "user", "wall")}


def by_scene(rows):
    found = {}
    for row in rows:
        found.setdefault(row["scene"], {})[row["program"]] = row
    return found


def missing(cases):
    gone = [LABELS[peer] for peer in ("povray", "tachyon")
            if not any(peer in p for p in cases.values())]
    return f" Left out, as not installed: {', '.join(gone)}." if gone else ""


def draw(data):
    figure, (axes,) = style.sheet(height=5.2)
    cases = {s: p for s, p in by_scene(data[NAME]).items() if s in CASES}
    if all(len(programs) == 1 for programs in cases.values()):
        raise RuntimeError("no data: no program to compare with is installed")
    names = list(cases)[::-1]
    for place, (program, label) in enumerate(LABELS.items()):
        for i, name in enumerate(names):
            # Times too short for a program's clock are none.
            if program in cases[name] and cases[name][program]["time_min"] > 0:
                own, peer = cases[name]["raytracer"], cases[name][program]
                ratio = peer["time"] / own["time"]
                bar = axes.barh(i + 0.27 * (1 - place), ratio, 0.25, color=COLOURS[program],
                                label=label, xerr=[[ratio - peer["time_min"] / own["time_max"]],
                                                   [peer["time_max"] / own["time_min"] - ratio]],
                                error_kw={"elinewidth": 0.8, "capsize": 2})
                axes.bar_label(bar, [f"{ratio:.2f}"], padding=4, fontsize=7.5)
                label = None
    axes.axvline(1, color=style.OWN, linewidth=1.2)
    axes.set(yticks=range(len(names)), yticklabels=[f"{n}: {CASES[n][3]}" for n in names],
             title=TITLE, xlabel="peer's trace time / ours (right of the line: we are faster)")
    axes.set_xscale("log")
    axes.set_xlim(axes.get_xlim()[0] / 1.1, axes.get_xlim()[1] * 1.4)
    style.plain_ticks_of(axes.xaxis)
    axes.grid(axis="y", visible=False)
    axes.legend(fontsize=8)
    return figure, (
        "Processor time of tracing, start-up left out; one thread, programs in turns, medians of "
        f"{data[NAME][0]['runs']:.0f} runs, whiskers: all pairs of runs. Tachyon has no tori and no "
        "glass, and samples half a pixel off. POV-Ray's checkers are point-sampled. "
        + speed_table.about_mitsuba(any("mitsuba" in p for p in cases.values())) + missing(cases)
        + " Figures: bench/results/speed.md")


def report(data, heading):
    return "speed.md", speed_table.page(by_scene(data[NAME]), heading, [*CASES], [*SOFT], LABELS)
