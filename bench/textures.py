#!/usr/bin/env python3
"""What filtering of textures saves: time against error, with and without it.

Renders bench/scenes/checker_plane.lua with a fixed number of samples, filtered and not, and
compares each with a reference of many unfiltered samples. Also the cost of noise, an octave at a
time. Writes bench/results/textures.csv and textures.md. Needs the release build's raytracer and
compare_images (argument: the build folder).
"""
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else root / "build/release").resolve()
work = pathlib.Path(tempfile.mkdtemp())
REFERENCE_SAMPLES = 4096


def render(scene, name, *options):
    """Processor seconds of tracing; the picture is work/name."""
    stats = work / "stats.json"
    subprocess.run([build / "raytracer", scene, "-q", "-o", name, "--stats", stats, *options],
                   check=True, cwd=work)
    return json.loads(stats.read_text())["pictures"][0]["seconds"]["trace_cpu"]


def best(runs, *arguments):
    return min(render(*arguments) for _ in range(runs))


def mean_difference(name):
    text = subprocess.run([build / "compare_images", work / name, work / "reference.exr"],
                          capture_output=True, text=True).stdout
    return float(re.search(r"mean ([-+.e0-9]+)", text).group(1))


def time_for(rows, error):
    """Time at which a curve comes down to an error, straight between points of the log-log plot."""
    for a, b in zip(rows, rows[1:]):
        if a["error"] >= error >= b["error"]:
            t = math.log(a["error"] / error) / math.log(a["error"] / b["error"])
            return a["seconds"] * (b["seconds"] / a["seconds"]) ** t
    return None


def filtering():
    scene = root / "bench/scenes/checker_plane.lua"
    render(scene, "reference.exr", "--samples", str(REFERENCE_SAMPLES), "--disable",
           "texture-filter", "--seed", "99")
    rows = []
    for filtered in (True, False):
        for samples in (1, 2, 4, 8, 16, 32, 64, 128, 256):
            off = [] if filtered else ["--disable", "texture-filter"]
            seconds = best(3, scene, "a.exr", "--samples", str(samples), *off)
            rows.append({"filtered": filtered, "samples": samples, "seconds": seconds,
                         "error": mean_difference("a.exr")})
    return rows


def noise():
    """Nanoseconds of processor time that one more octave of fbm adds to a lookup."""
    scene = work / "noise.lua"
    seconds = {}
    pixels, samples = 512 * 512, 4
    for octaves in (1, 17):
        scene.write_text(
            'local p = gr.plane("p"):set_material(gr.material(1, 0, 1)):rotate("x", 90)\n'
            "local o = {} for i = 1, %d do o[i] = {scale = 1 + 0.37 * i} end\n"
            "p:perlin_noise{octaves = o}\n"
            'gr.render{scene = p, file = "a.png", size = {512, 512}, ambient = 1, samples = %d,\n'
            "  camera = {eye = {0, 0, 9}, look_at = {0, 0, 0}}}\n" % (octaves, samples))
        seconds[octaves] = best(5, scene, "a.png")
    return (seconds[17] - seconds[1]) / 16 / (pixels * samples) * 1e9


def main():
    rows = filtering()
    octave = noise()
    results = root / "bench/results"
    results.mkdir(exist_ok=True)
    with open(results / "textures.csv", "w", newline="") as out:
        writer = csv.DictWriter(out, ["filtered", "samples", "seconds", "error"])
        writer.writeheader()
        writer.writerows(rows)
    on = [r for r in rows if r["filtered"]]
    off = [r for r in rows if not r["filtered"]]
    lines = ["# Filtered textures against unfiltered ones", "",
             "A checker plane to the horizon, 320 x 240 (bench/scenes/checker_plane.lua); error: mean",
             "absolute difference, linear, from %d unfiltered samples a pixel; seconds: processor time"
             % REFERENCE_SAMPLES,
             "of tracing, best of 3. Written by bench/textures.py.", "",
             "| samples | filtered s | error | unfiltered s | error |", "|---|---|---|---|---|"]
    for a, b in zip(on, off):
        lines.append("| %d | %.3f | %.5f | %.3f | %.5f |"
                     % (a["samples"], a["seconds"], a["error"], b["seconds"], b["error"]))
    lines += ["", "Time to an error, unfiltered over filtered:", "", "| error | ratio |", "|---|---|"]
    for a in on:
        t = time_for(off, a["error"])
        if t:
            lines.append("| %.5f | %.1f |" % (a["error"], t / a["seconds"]))
    lines += ["", "Noise, fbm on kd: %.1f ns an octave and lookup, footprint and hit not counted." % octave]
    (results / "textures.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
