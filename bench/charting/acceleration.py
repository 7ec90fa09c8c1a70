"""Acceleration: time of a picture, build included, against the number of primitives."""
from . import curves, style, tables
from .programs import ROOT

NAME, TITLE = "acceleration", "Finding hits: a picture's time against the number of primitives"
SCENE = ROOT / "bench/charting/scenes/many.lua"
LABELS = {"none": "one by one", "list": "list of boxes", "grid": "uniform grid",
          "bvh": "hierarchy", "auto": "auto (default)"}
LIMITS = {"none": 1000, "list": 10_000}  # beyond them a picture takes minutes


def case_of(context, method, count):
    """One picture; its processor time is that of compiling and of tracing."""
    size = "80x60" if context.quick else "320x240"

    def case():
        # Without the libraries that write pictures: their loading would share the processor.
        told = context.programs.render_only(SCENE, size, f"accel={method}", "--", count)
        return {"series": LABELS[method], "primitives": count, "size": size,
                "time": told["build"] + told["trace"], "build": told["build"],
                "trace": told["trace"], "rays": told["rays"], "memory": told["memory"]}
    return case


def measure(context):
    counts = (10, 100, 1000) if context.quick else (10, 30, 100, 300, 1000, 10_000, 100_000,
                                                    300_000)
    cases = [case_of(context, method, count) for count in counts for method in LABELS
             if count <= LIMITS.get(method, counts[-1])]
    return {NAME: tables.alternated(cases, context.runs, "time", "build", "trace")}


def draw(data):
    figure, panels = style.sheet(2, width=9)
    for index, (name, rows) in enumerate(curves.series(data[NAME]).items()):
        for axes, y in zip(panels, ("time", "build")):
            axes.plot([r["primitives"] for r in rows], [r[y] for r in rows],
                      style.MARKS[index] + ("--" if "auto" in name else "-"), label=name,
                      color=style.COLOURS[index])
    size = data[NAME][0]["size"]
    style.log_log(panels[0], "primitives", "processor time, s", f"Build and trace, {size}")
    style.log_log(panels[1], "primitives", "processor time, s", "Compiling the scene and building")
    panels[0].legend(fontsize=7.5)
    return figure, ("Half balls, half tori, each with its own transform, in a cloud; one ray a pixel "
                    "and its shadow rays. Medians of "
                    f"{data[NAME][0]['runs']:.0f} runs. bench/charting/scenes/many.lua")
