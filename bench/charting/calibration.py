"""Calibration: the true error against what --max-error claims, by scene."""
import csv
import io
import subprocess

from . import curves, style
from .programs import ROOT

NAME, TITLE = "calibration", "Does --max-error mean what it says?"
SCENES = (["bench/scenes/" + s for s in ("S1", "S2", "S3", "S4", "S5", "S5s")]
          + ["scenes/" + s for s in ("puppet", "mirror_room", "instancing")]
          + ["bench/calibration/scenes/" + s
             for s in ("wires", "checker", "glossy", "lens", "moving", "penumbra")])


def measure(context):
    samples, size = ("256", "16x12") if context.quick else ("16384", "48x36")
    scenes = SCENES[:2] + SCENES[-1:] if context.quick else SCENES
    said = subprocess.run(
        [context.build / "calibrate", "-r", samples, "-s", size, "-c",
         context.programs.cache / ("calibration-" + context.version),
         *[ROOT / (s + ".lua") for s in scenes]], check=True, capture_output=True, text=True).stdout
    rows = [{k: v if k == "scene" else float(v) for k, v in row.items()}
            | {"size": size, "reference_samples": samples}
            for row in csv.DictReader(io.StringIO(said))]
    return {NAME: rows}


def verdict(row):
    """What of the three demands a row misses."""
    missed = []
    if row["refined_p95/E"] > 1.5:
        missed.append(f"95% within {row['refined_p95/E']:.2f} E")
    if row["refined_mean/E"] > 1:
        missed.append("mean above E")
    if row["refined_mean/E"] < 0.2:
        missed.append("better than asked")
    # A bias that its own statistical error explains is none.
    if row["bias/E"] > 0.1 and abs(row["bias"]) > 3 * row["bias_error"]:
        missed.append("bias")
    return ", ".join(missed) or "holds"


def draw(data):
    figure, panels = style.sheet(2, width=9, height=5)
    for axes, what, title, low, high in (
            (panels[0], "refined_mean", "Mean true error", 0.2, 1),
            (panels[1], "refined_p95", "95th percentile of the true error", None, 1.5)):
        targets = sorted({row["target"] for row in data[NAME]})
        ends = [targets[0] / 1.3, targets[-1] * 1.3]
        axes.fill_between(ends, [(low or 1e-9) * e for e in ends], [high * e for e in ends],
                          color="#e8f1e8", label="asked for")
        axes.plot(ends, ends, color=style.GREY, linewidth=0.8)
        for index, (name, rows) in enumerate(curves.series(data[NAME], "scene").items()):
            axes.plot([r["target"] for r in rows], [r[what] for r in rows],
                      style.MARKS[index % 7] + "-", color=style.COLOURS[index % 7], label=name,
                      linewidth=0.8, fillstyle="full" if index < 7 else "none", markersize=4)
        style.log_log(axes, "--max-error", "displayed units", title)
        axes.set_ylim(ends[0] / 8, ends[1] * 2)
        axes.set_xlim(*ends)
    panels[1].legend(fontsize=6.5, bbox_to_anchor=(1, 1), loc="upper left")
    return figure, (f"Pixels that took more than their first samples, {data[NAME][0]['size']}; "
                    f"references of {data[NAME][0]['reference_samples']:.0f} samples with another "
                    "seed. Grey line: error = claim.")


def report(data, heading):
    """bench/results/calibration.md."""
    rows = data[NAME]
    held = sum(verdict(r) == "holds" for r in rows)
    lines = ["# Does the error target mean what it says?", "",
             *[f"{line}  " for line in heading], "",
             f"Pictures of {rows[0]['size']} pixels, references of "
             f"{float(rows[0]['reference_samples']):.0f} samples with another seed. Errors are in "
             "displayed units, of a pixel's worst channel, over the pixels that took more than "
             "their first samples.",
             "Asked for: the 95th percentile within 1.5 E, the mean between E/5 and E, and a bias "
             "below E/10 that its own statistical error does not explain.", "",
             f"**{held} of {len(rows)} hold.**", "",
             "| scene | E | samples a pixel | mean / E | 95% / E | bias / E | pixels within E | |",
             "|---|---|---|---|---|---|---|---|"]
    for r in rows:
        lines.append(f"| {r['scene']} | {r['target']:g} | {r['samples_per_pixel']:.1f} | "
                     f"{r['refined_mean/E']:.2f} | {r['refined_p95/E']:.2f} | {r['bias/E']:.3f} | "
                     f"{100 * r['share_within_E']:.1f}% | {verdict(r)} |")
    return "calibration.md", "\n".join(lines) + "\n"
