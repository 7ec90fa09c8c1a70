"""Antialiasing: what an error costs on S1, by scheme."""
from . import curves, style
from .programs import ROOT, Programs

NAME, TITLE = "antialiasing", "Antialiasing of S1: error against time"
SCENE = ROOT / "bench/scenes/S1.lua"
SIZE = (640, 480)

POV = {"POV-Ray +AM1": ["+AM1 +A0.3 +R3", "+AM1 +A0.1 +R3", "+AM1 +A0.1 +R5", "+AM1 +A0.03 +R5",
                        "+AM1 +A0.03 +R9"],
       "POV-Ray +AM2": ["+AM2 +A0.3 +R2", "+AM2 +A0.1 +R3", "+AM2 +A0.1 +R4", "+AM2 +A0.03 +R4",
                        "+AM2 +A0.01 +R5"]}


def measure(context):
    size = (64, 48) if context.quick else SIZE
    truth = curves.own_truth(context, SCENE, size, 128 if context.quick else 2048)
    cases = []
    for n in (1, 4, 16) if context.quick else (1, 4, 16, 64, 256):
        cases.append(curves.own_case(context, SCENE, ["--samples", str(n)], "uniform", size, truth))
    cases.append(curves.own_case(context, SCENE, ["--aa", "corners"], "corners (classic scheme)",
                                 size, truth))
    for e in (0.05, 0.02) if context.quick else (0.2, 0.1, 0.05, 0.03, 0.02, 0.014, 0.01, 0.005, 0.0025):
        cases.append(curves.own_case(context, SCENE, ["--max-error", str(e)], "adaptive", size,
                                     truth))
    if Programs.has("povray"):
        for label, settings in POV.items():
            # Its two methods converge to different pictures: they weigh a pixel's parts differently.
            finest = {"+AM1": ("+R4", "+R20"), "+AM2": ("+R3", "+R5")}[label.split()[1]]
            pov = curves.pov_truth(context, "S1", size,
                                   [label.split()[1], "-J", "+A0.0", finest[not context.quick]])
            for setting in settings[:1] if context.quick else settings:
                cases.append(curves.pov_case(context, "S1", [*setting.split(), "-J"], label, size,
                                             pov, truth))
    cases += curves.mitsuba_cases(context, "S1", size, truth, passes=4)
    return {NAME: curves.measured(context, cases)}


def draw(data):
    figure, panels = style.sheet(2, width=9.6)
    curves.draw(panels[0], data[NAME], "Error of values")
    curves.draw(panels[1], data[NAME], "Error as seen", error="flip", label_of_error="mean FLIP")
    panels[1].get_legend().remove()
    return figure, curves.floor(data[NAME])
