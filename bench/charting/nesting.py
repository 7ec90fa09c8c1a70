"""Gloss and motion: nested samples, as older ray tracers take them, against one path a sample."""
from . import curves, style
from .programs import ROOT

NAME, TITLE = "nesting", "Gloss and motion blur: nested samples against one path a sample"
SCENES = {"glossy": "Blurred mirrors under a spherical light", "moving": "Things that move"}
DEPTH = "2"  # reflections: a tree of nested rays grows with every one
NESTED = {"nested, at random": (16, "jittered"), "nested, well spread": (16, "nets"),
          "nested, well spread, 4 camera samples": (4, "nets")}


def scene_of(name):
    return ROOT / f"bench/calibration/scenes/{name}.lua"


def measure(context):
    size = (48, 36) if context.quick else (160, 120)
    rows = []
    for name in SCENES:
        scene, depth = scene_of(name), ["--max-depth", DEPTH]
        truth = curves.own_truth(context, scene, size, 128 if context.quick else 1024, *depth)
        cases = [curves.own_case(context, scene, ["--samples", str(n), *depth],
                                 "one path a sample", size, truth)
                 for n in ((4, 16) if context.quick else (1, 4, 16, 64, 256))]
        cases += [curves.own_case(context, scene, ["--max-error", str(e), *depth], "adaptive", size,
                                  truth) for e in ((0.05,) if context.quick else (0.05, 0.02, 0.01))]
        cases += [curves.driven_case(context, scene, (camera, nest, spread), label, size, truth,
                                     f"max_depth={DEPTH}")
                  for label, (camera, spread) in NESTED.items()
                  for nest in ((1, 2) if context.quick else (1, 2, 4, 8, 16))
                  if name != "glossy" or nest <= 8]
        rows += [{"scene": name, **row} for row in curves.measured(context, cases)]
    return {NAME: rows}


def draw(data):
    figure, panels = style.sheet(2, width=9.6)
    for axes, (name, rows) in zip(panels, curves.series(data[NAME], "scene").items()):
        curves.draw(axes, rows, SCENES[name])
    panels[1].get_legend().remove()
    return figure, (
        "Nested: bench/nesting takes 4 or 16 camera samples a pixel, and at each decision (time, place "
        "on the light, direction in the lobe) 1, 2, 4 ... of the next, down to two reflections; it "
        "uses this program's hits, lights and lobes. Both were compared with the same reference, of "
        f"error {max(r['reference_error'] for r in data[NAME]):.1e}.")
