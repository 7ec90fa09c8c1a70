"""Samplers: how errors fall on integrals whose values are known."""
import csv
import math
import subprocess

from . import curves, style

NAME, TITLE = "samplers", "Samplers on integrals of known value"


def measure(context):
    pixels, largest = (64, 64) if context.quick else (2048, 4096)
    said = subprocess.run([context.build / "bench_sampling", str(pixels), str(largest)], check=True,
                          capture_output=True, text=True).stdout
    rows = list(csv.DictReader(said.splitlines()))
    return {NAME: [row | {"count": int(row["count"]), "rmse": float(row["rmse"])} for row in rows]}


def draw(data):
    figure, panels = style.sheet(2, width=9)
    titles = {"penumbra": ("Penumbra from one point", "shadow rays"),
              "path": ("Pixel, gloss, light and time", "rays of every kind")}
    for axes, (integral, (title, unit)) in zip(panels, titles.items()):
        rows = [row for row in data[NAME] if row["integral"] == integral]
        for index, (name, points) in enumerate(curves.series(rows, "sampler").items()):
            fit = curves.slope([p for p in points if p["count"] > 4], "count")
            label = name if math.isnan(fit) else f"{name} (slope {fit:.2f})"
            style.line(axes, points, "count", "rmse", label, index)
        style.log_log(axes, unit, "RMSE of a visibility in [0,1]", title)
        axes.legend(fontsize=7.5)
    return figure, ("bench/sampling/sampling.cpp says what is integrated. "
                    "Nested: 16 samples a pixel, m x m rays at each, as older ray tracers do.\n"
                    "The fixed grid wins on the left, where nothing else varies: it errs alike in "
                    "neighbouring pixels, which shows as bands, and cannot be carried to the right.")
