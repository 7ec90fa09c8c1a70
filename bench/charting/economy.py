"""Economy: instructions that a feature costs where it is used and where it is not."""
import re
import subprocess

from . import style
from .programs import ROOT, Programs

NAME, TITLE = "economy", "What a feature costs: instructions with it over instructions without"
PLAIN = ROOT / "bench/charting/scenes/plain.lua"
BENCH, CALIBRATION = ROOT / "bench/scenes", ROOT / "bench/calibration/scenes"
# Each with a scene that uses it.
FEATURES = {"reflection": BENCH / "S1.lua", "refraction": BENCH / "S4.lua",
            "soft_shadows": BENCH / "S5.lua", "glossy": CALIBRATION / "glossy.lua",
            "motion_blur": CALIBRATION / "moving.lua"}


def instructions(context, scene, *words):
    """Of compiling and tracing, and the picture's digest."""
    size = "16x12" if context.quick else "80x60"
    out = context.programs.scratch / "callgrind.out"
    done = subprocess.run(
        ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}",
         "--toggle-collect=rt::planned_and_traced*", context.build / "render_only", scene, size,
         "samples=4", *words], check=True, capture_output=True, text=True)
    return int(re.search(r"Collected : (\d+)", done.stderr).group(1)), done.stdout.split()[0]


def measure(context):
    if not Programs.has("valgrind"):
        return {NAME: []}
    rows = []
    plain, digest = instructions(context, PLAIN)
    for feature, scene in list(FEATURES.items())[:2 if context.quick else None]:
        off, off_digest = instructions(context, PLAIN, feature + "=off")
        with_it, _ = instructions(context, scene)
        without, _ = instructions(context, scene, feature + "=off")
        rows.append({"feature": feature, "unused_on": plain, "unused_off": off,
                     "same_picture": int(digest == off_digest), "scene": scene.stem,
                     "used_on": with_it, "used_off": without})
    return {NAME: rows}


def draw(data):
    figure, (axes,) = style.sheet(height=3.4)
    names = [row["feature"].replace("_", " ") for row in data[NAME]]
    for shift, kind, colour, label in ((0.2, "unused", style.OWN, "scene without it"),
                                       (-0.2, "used", style.POVRAY, "scene that uses it")):
        ratios = [row[kind + "_on"] / row[kind + "_off"] for row in data[NAME]]
        bars = axes.barh([i + shift for i in range(len(names))], ratios, 0.38, color=colour,
                         label=label)
        axes.bar_label(bars, [f"{r:.4f}" if kind == "unused" else f"{r:.2f}" for r in ratios],
                       padding=3, fontsize=8)
    axes.set(yticks=range(len(names)), yticklabels=names, title=TITLE,
             xlabel="instructions of compiling and tracing, feature on / off")
    axes.axvline(1, color=style.GREY, linewidth=0.8)
    axes.grid(axis="y", visible=False)
    axes.legend(fontsize=8)
    return figure, ("Counted by callgrind, 4 samples a pixel; unused: bench/charting/scenes/"
                    "plain.lua, where both pictures are byte-equal.")
