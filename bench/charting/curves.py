"""Error against time of many settings: what the charts of antialiasing and of soft shadows share."""
import math

from . import flip, pictures, style, tables
from .programs import ROOT

PEERS = ("POV-Ray", "Mitsuba")


def own_case(context, scene, options, label, size, truth):
    picture = truth[0]

    def case():
        run = context.programs.raytracer(scene, "-s", f"{size[0]}x{size[1]}", "--filter", "box",
                                         *options)
        return {"series": label, "setting": " ".join(options), "time": run.trace,
                "rmse": pictures.rmse(run.picture, picture),
                "flip": flip.mean_flip(run.picture, picture),
                "rays": run.stats["rays"]["total"], "reference_error": truth[1]}
    return case


def driven_case(context, scene, nesting, label, size, truth, *options):
    """By bench/nesting: camera samples, samples of each decision, and how they are spread."""
    out = context.programs.scratch / "nested.pfm"

    def case():
        said, _, _, _ = context.programs.timed(
            [context.build / "bench_nested", scene, f"{size[0]}x{size[1]}", *nesting, out, *options])
        seconds, rays = map(float, said.split())
        picture = pictures.read(out)
        if not pictures.differ_by_noise(picture, truth[0]):
            raise RuntimeError(f"{scene.stem}, {label}: the samples make another picture")
        return {"series": label, "setting": " x ".join(map(str, nesting[:2])), "time": seconds,
                "rmse": pictures.rmse(picture, truth[0]), "flip": flip.mean_flip(picture, truth[0]),
                "rays": rays, "reference_error": truth[1]}
    return case


def pov_case(context, scene, options, label, size, truth, own):
    """`truth` is POV-Ray's, `own` ours; what is between them is no error of either's sampling."""
    between = pictures.rmse(truth[0], own[0])

    def case():
        run = context.programs.povray(scene, size, *options)
        return {"series": label, "setting": " ".join(options), "time": run.trace,
                "rmse": pictures.rmse(run.picture, truth[0]),
                "flip": flip.mean_flip(run.picture, truth[0]),
                "rays": run.stats["rays"], "reference_error": truth[1], "between": between}
    return case


def own_truth(context, scene, size, samples, *options):
    """Two references of other seeds than any picture's, and their mean."""
    def make(seed):
        return lambda: context.programs.raytracer(
            scene, "-s", f"{size[0]}x{size[1]}", "--filter", "box", "--samples", str(samples),
            "--seed", str(seed), "--max-error", "1e-4", *options, threads=context.threads).picture
    return context.programs.reference(("own", str(scene), scene.read_text(), size, samples, options,
                                       context.version), make(12345), make(54321))


def pov_truth(context, scene, size, options):
    text = (context.programs.peers / f"{scene}.pov").read_text()
    return context.programs.reference(
        ("povray", text, size, options),
        lambda: context.programs.povray(scene, size, *options).picture)


def mitsuba_cases(context, scene, size, own, passes=16):
    """What Mitsuba does with the scene, if it is there; against a reference of its own, of so many
    times 256 samples."""
    if not context.programs.mitsuba_python:
        return
    samples, passes = (16, 4) if context.quick else (256, passes)

    def make(seed):
        return lambda: context.programs.mitsuba(scene, size, samples, passes, seed).picture
    text = "".join((ROOT / name).read_text() for name in
                   (f"bench/scenes/{scene}.lua", "bench/mitsuba_peer.py"))
    truth = context.programs.reference(("mitsuba", text, size, samples, passes), make(1000),
                                       make(2000))
    between = pictures.rmse(truth[0], own[0])

    def case_of(count):
        def case():
            run = context.programs.mitsuba(scene, size, count)
            return {"series": "Mitsuba, multijitter", "setting": f"{count} samples",
                    "time": run.trace, "rmse": pictures.rmse(run.picture, truth[0]),
                    "flip": flip.mean_flip(run.picture, truth[0]), "rays": "",
                    "reference_error": truth[1], "between": between}
        return case
    yield from map(case_of, (4,) if context.quick else (4, 16, 64, 256))


def measured(context, cases):
    rows = tables.alternated(cases, context.runs, "time")
    # Processor times of POV-Ray come in hundredths of a second.
    return [row for row in rows if row["time"] > 0]


def slope(rows, x="time", y="rmse"):
    """Of the least squares line in logarithms."""
    points = [(math.log(r[x]), math.log(r[y])) for r in rows if r[x] > 0 and r[y] > 0]
    if len(points) < 3:
        return math.nan
    mean_x, mean_y = (sum(p[k] for p in points) / len(points) for k in (0, 1))
    return (sum((p - mean_x) * (q - mean_y) for p, q in points) /
            sum((p - mean_x) ** 2 for p, _ in points))


def series(rows, name="series"):
    """The rows by series, in the order in which they come."""
    found = {}
    for row in rows:
        found.setdefault(row[name], []).append(row)
    return found


def draw(axes, rows, title, slopes=False, error="rmse", label_of_error="linear RMSE"):
    for index, (name, points) in enumerate(series(rows).items()):
        own = not name.startswith(PEERS)
        label = name
        if slopes and not math.isnan(slope(points)):
            label += f" (slope {slope(points):.2f})"
        style.line(axes, points, "time", error, label, index, dash="-" if own else "--")
    for row in rows:
        if row["series"] == "adaptive" and str(row["setting"]).endswith("--max-error 0.02"):
            axes.annotate("default", (row["time"], row[error]), (-14, -26), fontsize=8,
                          textcoords="offset points", ha="center",
                          arrowprops={"arrowstyle": "-", "color": style.GREY})
    style.log_log(axes, "processor time of tracing, s", label_of_error, title)
    axes.legend(fontsize=7.5)


def numbers(rows, name, peer=""):
    return [r[name] for r in rows if str(r["series"]).startswith(peer)
            and isinstance(r.get(name), float) and not math.isnan(r[name])]


def floor(rows, peers=PEERS):
    """What the references' own errors are, and how far the peers' are from ours, in words."""
    own = max((r["reference_error"] for r in rows if not str(r["series"]).startswith(PEERS)
               and isinstance(r["reference_error"], float)), default=math.nan)
    text = f"Each against its own converged reference (ours: error {own:.1e})."
    pov, mitsuba = (numbers(rows, "between", peer) for peer in PEERS)
    if pov:
        text += (f" POV-Ray's differs from ours by up to {max(pov):.1e}; it is made of the same regular "
                 "points as its pictures, so that errors they share do not show.")
    if mitsuba:
        text += (f" Mitsuba's (error {max(numbers(rows, 'reference_error', 'Mitsuba')):.1e}) differs by "
                 f"{max(mitsuba):.1e}: single precision, tori as meshes; it runs SIMD wavefronts, and "
                 "compiling its kernel is not counted.")
    missing = [name for name, found in zip(PEERS, (pov, mitsuba)) if name in peers and not found]
    return text + (f" Left out, as not installed: {', '.join(missing)}." if missing else "")
