"""Textures: what filtering saves at equal error, and what octaves of noise cost."""
from . import curves, style, tables
from .programs import ROOT

NAME, TITLE = "textures", "Textures filtered over footprints; noise by octaves"
SCENE = ROOT / "bench/scenes/checker_plane.lua"
NOISE = ROOT / "bench/charting/scenes/noise.lua"


def measure(context):
    size = (64, 48) if context.quick else (200, 150)
    truth = curves.own_truth(context, SCENE, size, 128 if context.quick else 2048)
    cases = []
    for n in (1, 4, 16) if context.quick else (1, 4, 16, 64, 256):
        for label, more in (("filtered", []), ("unfiltered", ["--disable", "texture-filter"])):
            cases.append(curves.own_case(context, SCENE, ["--samples", str(n), *more], label, size,
                                         truth))
    rows = curves.measured(context, cases)
    return {NAME: [row | {"panel": "error"} for row in rows] + noise(context)}


def noise(context):
    side = 64 if context.quick else 384

    def case_of(octaves):
        def case():
            run = context.programs.raytracer([NOISE, octaves], "-s", f"{side}x{side}",
                                             "--samples", "4")
            lookups = run.stats["rays"]["camera"]
            return {"panel": "noise", "series": "fbm on kd", "octaves": octaves,
                    "time": run.trace / lookups * 1e9}
        return case
    return tables.alternated([case_of(n) for n in (1, 3, 5, 9, 17)], context.runs, "time")


def draw(data):
    figure, panels = style.sheet(2, width=9)
    errors = [row for row in data[NAME] if row["panel"] == "error"]
    for index, (name, rows) in enumerate(curves.series(errors).items()):
        style.line(panels[0], rows, "time", "rmse", name, index)
    style.log_log(panels[0], "processor time of tracing, s", "linear RMSE",
                  "A checker to the horizon")
    panels[0].legend(fontsize=7.5)
    octaves = [row for row in data[NAME] if row["panel"] == "noise"]
    xs, ys = ([row[k] for row in octaves] for k in ("octaves", "time"))
    panels[1].plot(xs, ys, "o-", color=style.OWN)
    each = (ys[-1] - ys[0]) / (xs[-1] - xs[0])
    panels[1].set(xlabel="octaves", ylabel="processor time of a sample, ns",
                  title=f"Noise: {each:.0f} ns an octave", ylim=(0, None))
    return figure, curves.floor(errors, peers=())
