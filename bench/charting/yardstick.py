"""The price of generality: one ball under one light, against loops that can do nothing else."""
import csv
import subprocess

from . import tables
from .programs import ROOT

NAME, TITLE = "yardstick", "One ball, one light: the renderer against loops written for it"
SCENE = ROOT / "bench/yardstick/one_ball.lua"
ASKED = 1.1


def measure(context):
    size, rounds = ("320x240", 5) if context.quick else ("1024x768", 31)
    said = subprocess.run([*context.programs.pin, context.programs.best("bench_yardstick"), SCENE, size,
                           str(rounds)], check=True, capture_output=True, text=True).stdout
    rows = []
    for row in csv.DictReader(said.splitlines()):
        row = {k: float(v) for k, v in row.items()}
        rows.append({"size": size, "largest_difference": row["largest_difference"],
                     "renderer": row["renderer"], "least": row["least"], "usual": row["usual"],
                     "over_least": row["renderer"] / row["least"],
                     "over_usual": row["renderer"] / row["usual"]})
    return {NAME: [tables.median_row(rows, "renderer", "least", "usual", "over_least",
                                     "over_usual")]}


def report(data, heading):
    (row,) = data[NAME]
    loops = [("renderer", "this program, as it renders any scene", None),
             ("usual", "loop with a shadow ray where the light is faced", "over_usual"),
             ("least", "loop that knows that a ball cannot shade what of it faces the light",
              "over_least")]
    width, height = map(int, row["size"].split("x"))
    table = tables.markdown({
        "": lambda r: r[1],
        "ms": lambda r: f"{1e3 * row[r[0]]:.2f}",
        "ns a pixel": lambda r: f"{1e9 * row[r[0]] / width / height:.1f}",
        "renderer / loop [least, largest]":
            lambda r: tables.between(row, r[2], "{:.2f}") if r[2] else ""}, loops)
    held = ("reached" if row["over_least"] <= ASKED else
            "reached against the usual loop only" if row["over_usual"] <= ASKED else "not reached")
    return NAME + ".md", tables.page(
        TITLE, heading,
        f"bench/yardstick: {row['size']}, one ray a pixel, double precision, one thread, processor "
        f"time, medians of {row['runs']:.0f} rounds in turns. The pictures were compared first: no "
        f"value differs by more than {row['largest_difference']:.1e} of 1.", table,
        f"Aimed at: at most {ASKED:g} times the loop's time. {held.capitalize()}.")
