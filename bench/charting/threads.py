"""Two threads against one, on every scene of the bench, made large enough to take its time."""
import math
import os
import statistics

from . import style, tables
from .programs import ROOT, Programs

NAME, TITLE = "threads", "Two threads: how many times as fast as one"
SCENES = ["S1", "S1n", "S2", "S3", "S3b", "S4", "S5", "S5s"]
SECONDS, ASKED = 1.0, 1.9


def unpinned(context):
    """Its runs may use every processor."""
    programs = Programs(context.build, context.programs.scratch, context.programs.cache, 0)
    programs.pin = []
    return programs


def size_for(programs, scene, seconds):
    """The 4 to 3 shape at which one thread traces for about so long."""
    probe = programs.raytracer(scene, "-s", "160x120", "--samples", "1", picture=False)
    edge = math.sqrt(1.3 * seconds / max(probe.trace, 1e-4))
    return f"{round(160 * edge)}x{round(120 * edge)}"


def case_of(programs, name, scene, size):
    def case():
        one, two = (programs.raytracer([ROOT / "bench/scenes/twice.lua", scene], "-s", size,
                                       "--samples", "1", picture=False, threads=n) for n in (1, 2))
        # Of the second picture; of the first, while OpenImageIO is loaded on the second processor.
        first, clock = ([run.all[k]["seconds"]["trace"] for run in (one, two)] for k in (0, 1))
        processor = [run.all[1]["seconds"]["trace_cpu"] for run in (one, two)]
        return {"scene": name, "size": size, "one": clock[0], "two": clock[1],
                "speedup": clock[0] / clock[1], "processor": processor[1] / processor[0],
                "first": first[0] / first[1], "memory": (two.memory - one.memory)}
    return case


def measure(context):
    if os.cpu_count() < 2:
        raise RuntimeError("one processor: two threads cannot be measured")
    programs = unpinned(context)
    seconds = 0.05 if context.quick else SECONDS
    cases = []
    for name in SCENES[:2] if context.quick else SCENES:
        scene = ROOT / f"bench/scenes/{name}.lua"
        cases.append(case_of(programs, name, scene, size_for(programs, scene, seconds)))
    return {NAME: tables.alternated(cases, context.runs, "one", "two", "speedup", "first", "processor",
                                     "memory")}


def draw(data):
    figure, (axes,) = style.sheet(height=3.2)
    rows = data[NAME][::-1]
    ratios = [r["speedup"] for r in rows]
    bars = axes.barh(range(len(rows)), ratios, 0.6, color=style.OWN,
                     xerr=[[r["speedup"] - r["speedup_min"] for r in rows],
                           [r["speedup_max"] - r["speedup"] for r in rows]],
                     error_kw={"elinewidth": 0.8, "capsize": 2})
    axes.bar_label(bars, [f"{r:.2f}" for r in ratios], padding=8, fontsize=8)
    axes.axvline(ASKED, color=style.GREY, linewidth=0.9, linestyle=":")
    axes.set(yticks=range(len(rows)), yticklabels=[r["scene"] for r in rows], title=TITLE,
             xlabel="time of tracing with one thread / with two", xlim=(0, 2.35))
    axes.grid(axis="y", visible=False)
    return figure, ("Wall time of tracing, medians and spread of "
                    f"{rows[0]['runs']:.0f} pairs of runs, one ray a pixel, "
                    f"pictures large enough for {SECONDS:g} s. Dotted: aimed at. The second picture of a "
                    "script: the first is traced while OpenImageIO is loaded on the other processor.")


def report(data, heading):
    table = tables.markdown({
        "scene": lambda r: r["scene"], "size": lambda r: r["size"],
        "one thread, s": lambda r: tables.between(r, "one"),
        "two, s": lambda r: tables.between(r, "two"),
        "one / two": lambda r: tables.between(r, "speedup", "{:.2f}"),
        "first picture": lambda r: tables.between(r, "first", "{:.2f}"),
        "processor time, two / one": lambda r: tables.between(r, "processor", "{:.2f}"),
        "memory of the second, MB": lambda r: f"{r['memory'] / 1e6:.1f}"}, data[NAME])
    held = sum(r["speedup"] >= ASKED for r in data[NAME])
    return NAME + ".md", tables.page(
        TITLE, heading, "One ray a pixel; wall time of tracing, medians [least, largest] of pairs of "
        "runs, each with one thread and then with two. Each run renders the scene twice, and the second "
        "picture counts: the first, whose ratio stands beside, is traced while OpenImageIO is loaded on "
        "the other processor, for a quarter of a second of its time. The ratio of processor times "
        "does not see what else the machine does: at 1.00 two threads do the "
        "work of one and no more, and what the first ratio lacks of 2 is waiting or other programs' "
        "time.", table,
        f"Aimed at: {ASKED:g} on each. Reached on {held} of {len(data[NAME])}; median "
        f"{statistics.median(r['speedup'] for r in data[NAME]):.2f}.")
