"""docs/accuracy.md: its words are accuracy.md.in, its figures come from the charts' data."""
import pathlib
import statistics

from . import calibration, curves, tables, whole_scenes
from .antialiasing import SIZE

TABLES = ["torus", "leaving", "samplers", "calibration", "antialiasing", "soft_shadows", "nesting",
          "whole_scenes", "economy"]
# S4 as we render it by default is not the peers' picture.
SAME_PICTURE = set(whole_scenes.CASES) - {"S4"}


def of_torus(rows):
    own = [r for r in rows if r["method"] == "this program"]
    ferrari = [r for r in rows if r["method"] == "Ferrari, recentred"]
    for name, found in (("own", own), ("ferrari", ferrari)):
        yield name + "_fast", min(r["ns"] for r in found)
        yield name + "_slow", max(r["ns"] for r in found)
        yield name + "_error", max(r["error"] for r in found)
    yield "families", len(own)
    yield "torus_rays", f"{sum(r['rays'] for r in own):,.0f}"
    yield "own_missed", f"{sum(r['missed'] for r in own):.0f}"
    yield "own_false", f"{sum(r['false'] for r in own):.0f}"
    yield "ferrari_worst", 1e-4 * max(r["missed"] + r["false"] for r in ferrari)
    yield "price", max(a["ns"] / b["ns"] for a, b in zip(own, ferrari))


def of_leaving(rows):
    by = curves.series(rows, "policy")

    def failures(policy):
        wrong = sum(r["false_hits"] + r["leaks"] + r["wrong"] for r in by[policy])
        return f"{wrong:,.0f}"
    side = by["side (this program)"]
    rays = sum(r["rays"] for r in side)
    yield "leaving_rays", f"{rays:,.0f}"
    yield "leaving_own", failures("side (this program)")
    yield "leaving_epsilon", failures("t > 1e-6")
    yield "leaving_offset", failures("rounding-bound offset")
    yield "leaving_below", 100 * sum(r["below_resolution"] for r in side) / rays


def of_samplers(rows, s5):
    for name, integral, sampler in (("sobol", "penumbra", "Owen-Sobol"),
                                    ("random", "penumbra", "random"),
                                    ("path", "path", "one path a sample by Owen-Sobol"),
                                    ("path_random", "path", "one path a sample at random")):
        yield "slope_" + name, curves.slope(
            [r for r in rows if (r["integral"], r["sampler"]) == (integral, sampler)
             and r["count"] > 4], "count")
    yield "slope_s5", curves.slope([r for r in s5 if str(r["series"]).startswith("uniform")])


def of_calibration(rows):
    p95, mean = ([r[k] for r in rows] for k in ("refined_p95/E", "refined_mean/E"))
    yield "calibration_scenes", len({r["scene"] for r in rows})
    yield "calibration_rows", len(rows)
    yield "calibration_reference", f"{rows[0]['reference_samples']:.0f}"
    for name, values in (("p95", p95), ("mean", mean)):
        yield from ((name + "_low", min(values)), (name + "_high", max(values)),
                    (name + "_median", statistics.median(values)))
    yield "p95_missed", sum(v > 1.5 for v in p95)
    yield "mean_above", sum(v > 1 for v in mean)
    yield "mean_below", sum(v < 0.2 for v in mean)
    yield "bias_high", max(r["bias/E"] for r in rows)
    yield "bias_missed", sum("bias" in calibration.verdict(r) for r in rows)
    worst = max(rows, key=lambda r: r["refined_p95/E"])
    yield from (("p95_scene", worst["scene"]), ("p95_target", worst["target"]))
    least = min(rows, key=lambda r: r["share_within_E"])
    yield "outside", 100 * (1 - statistics.mean(r["share_within_E"] for r in rows))
    yield "outside_worst", 100 * (1 - least["share_within_E"])
    yield "outside_scene", f"{least['scene']} at E = {least['target']:g}"
    failing = [f"{r['scene']} at {r['target']:g} ({calibration.verdict(r)})" for r in rows
               if calibration.verdict(r) != "holds"]
    yield "held", len(rows) - len(failing)
    yield "failing", "; those that do not: " + "; ".join(failing) if failing else ""


def time_for(rows, error):
    """Of the fastest row that errs no more; linear in logarithms between two rows."""
    rows = sorted(rows, key=lambda r: r["rmse"])
    for better, worse in zip(rows, rows[1:]):
        if better["rmse"] <= error <= worse["rmse"]:
            share = (curves.math.log(error / better["rmse"])
                     / curves.math.log(worse["rmse"] / better["rmse"]))
            return better["time"] ** (1 - share) * worse["time"] ** share
    return None


def of_s5(rows):
    """Our adaptive sampling against POV-Ray's adaptive light, at the errors that both reach."""
    by = curves.series(rows)
    theirs, words = by.get("POV-Ray, adaptive", []), []
    for error in (0.002, 0.001, 0.0007):
        pair = [time_for(r, error) for r in (theirs, by["adaptive"])]
        if all(pair):
            words.append(f"{pair[0] / pair[1]:.2f} times ours at an RMSE of {error:g}")
    yield "s5", ("POV-Ray's adaptive light takes " + ", ".join(words) if words else
                 "POV-Ray was not measured")


def of_nesting(rows):
    """How much longer the best of the nested settings takes to err as little as the finest does."""
    for scene, found in curves.series(rows, "scene").items():
        by = curves.series(found)
        nested = [r for r in found if r["series"].startswith("nested")]
        least = min(nested, key=lambda r: r["rmse"])
        own = time_for(by["one path a sample"], least["rmse"])
        yield "nested_" + scene, (f"{least['time'] / own:.1f} times as long at an RMSE of "
                                  f"{least['rmse']:.1g}" if own else "an error out of reach")


def of_costs(antialiasing, scenes, economy):
    by = curves.series(antialiasing)
    default = next(r for r in by["adaptive"] if r["setting"] == "--max-error 0.02")
    yield from (("default_rmse", default["rmse"]), ("default_time", default["time"]),
                ("default_flip", default.get("flip", float("nan"))))
    yield "uniform_ratio", (time_for(by["uniform"], default["rmse"]) or 0) / default["time"]
    reached = [r["time"] for r in antialiasing
               if r["series"].startswith("POV") and r["rmse"] <= default["rmse"]]
    yield "pov_ratio", (f"{min(reached) / default['time']:.1f} times (its fastest setting that errs "
                        "no more)" if reached else "does not reach it with any setting tried")
    yield "s1_size", "{}x{}".format(*SIZE)
    for peer, name in (("povray", "pov"), ("tachyon", "tachyon"), ("mitsuba", "mitsuba")):
        own = {r["scene"]: r["time"] for r in scenes if r["program"] == "raytracer"}
        ratios = [r["time"] / own[r["scene"]] for r in scenes
                  if r["program"] == peer and r["scene"] in SAME_PICTURE]
        yield name, f"{min(ratios):.2f} to {max(ratios):.2f}" if ratios else "not measured"
    yield "economy", max(100 * abs(r["unused_on"] / r["unused_off"] - 1) for r in economy)


def write(data_folder, target):
    """Writes the page; says which data are missing where it cannot."""
    missing = [t for t in TABLES if not (data_folder / f"{t}.csv").exists()]
    if missing:
        return f"not written: there are no data of {', '.join(missing)}"
    data, heading = {}, []
    for name in TABLES:
        data[name], heading = tables.read(data_folder / f"{name}.csv")
    facts = {k: tables.stated(heading, k) for k in ("machine", "versions", "date")}
    facts |= dict([*of_torus(data["torus"]), *of_leaving(data["leaving"]),
                   *of_samplers(data["samplers"], data["soft_shadows"]),
                   *of_calibration(data["calibration"]), *of_s5(data["soft_shadows"]),
                   *of_nesting(data["nesting"]),
                   *of_costs(data["antialiasing"], data["whole_scenes"], data["economy"])])
    words = (pathlib.Path(__file__).parent / "accuracy.md.in").read_text()
    target.write_text(words.format(**facts))
    return "written"
