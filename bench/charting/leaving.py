"""Leaving a surface: rays that err, by policy and scale."""
import csv
import subprocess

from . import curves, style

NAME, TITLE = "leaving", "Leaving a surface: wrong secondary rays against the scene's scale"


def measure(context):
    said = subprocess.run([context.build / "bench_leaving", "20" if context.quick else "1000"],
                          check=True, capture_output=True, text=True).stdout
    return {NAME: [{k: v if k == "policy" else float(v) for k, v in row.items()}
                   for row in csv.DictReader(said.splitlines())]}


def draw(data):
    figure, panels = style.sheet(2, width=9)
    for index, (name, rows) in enumerate(curves.series(data[NAME], "policy").items()):
        for axes, what in zip(panels, (("false_hits", "wrong"), ("leaks",))):
            rate = [max(1e6 * sum(r[k] for k in what) / r["rays"], 1e6 / r["rays"] / 3)
                    for r in rows]
            axes.plot([r["scale"] for r in rows], rate, style.MARKS[index] + "-", label=name,
                      color=style.COLOURS[index], markersize=7 - index)
    for axes, title in zip(panels, ("False and wrong crossings", "Leaks")):
        style.log_log(axes, "scale of the scene", "per million rays", title)
    panels[0].legend(fontsize=7.5)
    rays = int(data[NAME][0]["rays"])
    return figure, (f"{rays} rays a mark; none is drawn at a third of one among them. All shapes, "
                    "at the world's origin and 1e3 sizes away; a quarter of the rays graze. "
                    "Rays whose answer turns on the rounding of their own origin are not counted.")
