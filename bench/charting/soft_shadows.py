"""Soft shadows: what an error costs on S5, antialiased, by how the light is sampled."""
from . import curves, style
from .programs import ROOT, Programs

NAME, TITLE = "soft_shadows", "Soft shadows (S5, antialiased): error against time"
SCENE = ROOT / "bench/scenes/S5.lua"
AA3, AA4 = ["+AM2", "+A0.1", "+R3", "-J"], ["+AM2", "+A0.03", "+R4", "-J"]


def light(n, adaptive=-1, jitter=0):
    return [f"Declare=AN={n}", f"Declare=AAD={adaptive}", f"Declare=AJ={jitter}"]


POV = {"POV-Ray, fixed grid": [AA3 + light(4), AA3 + light(8), AA4 + light(16)],
       "POV-Ray, jittered": [AA3 + light(4, jitter=1), AA3 + light(8, jitter=1),
                             AA4 + light(16, jitter=1)],
       "POV-Ray, adaptive": [AA3 + light(5, 0), AA3 + light(9, 0), AA4 + light(9, 0),
                             AA4 + light(17, 0), AA4 + light(33, 0)]}


def measure(context):
    size = (64, 48) if context.quick else (200, 150)
    truth = curves.own_truth(context, SCENE, size, 128 if context.quick else 1024)
    cases = []
    for n in (1, 4, 16) if context.quick else (1, 4, 16, 64, 256):
        cases.append(curves.own_case(context, SCENE, ["--samples", str(n)], "uniform (Owen-Sobol)",
                                     size, truth))
        # What the program does not offer, on its own scene and lights: bench/nesting.
        cases += [curves.driven_case(context, SCENE, (n, 1, spread), label, size, truth)
                  for spread, label in (("random", "all at random"), ("stratified", "stratified"))]
    for e in (0.05, 0.02) if context.quick else (0.1, 0.05, 0.02, 0.01, 0.005, 0.0025):
        cases.append(curves.own_case(context, SCENE, ["--max-error", str(e)], "adaptive", size,
                                     truth))
    if Programs.has("povray"):
        best = ["+AM2", "-J", "+A0.0", "+R2" if context.quick else "+R4",
                *(light(5, 0) if context.quick else light(33, 1))]
        pov = curves.pov_truth(context, "S5", size, best)
        for label, settings in POV.items():
            for setting in settings[:1] if context.quick else settings:
                cases.append(curves.pov_case(context, "S5", setting, label, size, pov,
                                             truth))
    cases += curves.mitsuba_cases(context, "S5", size, truth)
    return {NAME: curves.measured(context, cases)}


def draw(data):
    figure, (axes,) = style.sheet()
    curves.draw(axes, data[NAME], TITLE, slopes=True)
    note = curves.floor(data[NAME])
    if any(r["series"] == "POV-Ray, adaptive" for r in data[NAME]):
        note += (" POV-Ray's adaptive light sends few shadow rays where those to its corners agree, and "
                 "does not see what lies between; where it is the faster one, that is why.")
    return figure, note
