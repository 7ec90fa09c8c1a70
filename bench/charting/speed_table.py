"""bench/results/speed.md: whole scenes in figures."""
import statistics

from . import tables


def about_mitsuba(there):
    if not there:
        return "Mitsuba was not installed: left out."
    return ("Mitsuba (llvm, SIMD over wavefronts, single precision) runs a loop of the same terms of "
            "light; its planes are finite, its tori meshes, and glass and checkers were not brought "
            "over; the compiling of its kernel is not counted. Where it is the faster one, that is why: "
            "its registers hold twice as many numbers as ours, which are in double precision.")


def rate(row):
    rays, time = row["rays"], row["time"]
    return f"{rays / time / 1e6:.1f}" if rays and time else "-"


def compared(cases, names):
    """Rows of the table of trace times, one a scene and program."""
    for name in names:
        for program, row in cases.get(name, {}).items():
            own = cases[name]["raytracer"]["time"]
            yield row | {"ratio": "" if program == "raytracer" else f"{row['time'] / own:.2f}",
                         "apart": "" if program == "raytracer" else f"{100 * row['differing']:.2f}%",
                         "rate": rate(row)}


def table(rows, *more):
    columns = {
        "scene": lambda r: r["scene"], "program": lambda r: r["program"],
        "size": lambda r: r["size"], "trace, s": lambda r: tables.between(r, "time"),
        "peer / ours": lambda r: r["ratio"], "M rays/s": lambda r: r["rate"],
        "whole process, user s": lambda r: f"{r['user']:.2f}",
        "memory, MB": lambda r: f"{r['memory'] / 1e6:.0f}", "differing": lambda r: r["apart"]}
    return tables.markdown(columns | dict(more), rows)


def phases(cases):
    rows = [programs["raytracer"] for programs in cases.values()]

    def seconds(name):
        return lambda r: f"{r[name]:.4f}" if r[name] != "" else ""
    return tables.markdown({"scene": lambda r: r["scene"], "script": seconds("script"),
                            "plan": seconds("plan"),
                            "trace (processor)": lambda r: f"{r['time']:.4f}",
                            "write": seconds("write"),
                            "whole process": lambda r: f"{r['wall']:.2f}"}, rows)


def ratios(cases, names, labels):
    """One line a peer."""
    for program, label in labels.items():
        found = [cases[n][program]["time"] / cases[n]["raytracer"]["time"] for n in names
                 if program in cases.get(n, {})]
        if found:
            yield (f"{label}'s time over ours: median **{statistics.median(found):.2f}**, "
                   f"{min(found):.2f} to {max(found):.2f} over {len(found)} scenes.  ")


def page(cases, heading, scenes, soft, labels):
    start = tables.markdown({
        "program": lambda r: r["program"], "user, s": lambda r: f"{r['user']:.3f}",
        "wall, s": lambda r: tables.between(r, "wall")}, cases["trivial"].values())
    there = any("mitsuba" in programs for programs in cases.values())
    return tables.page(
        "Speed against other ray tracers", heading,
        "Medians [least, largest] of runs in turns, one thread, one ray a pixel. Trace: processor time "
        "of tracing by each program's own statistics (Tachyon states wall time; where the process took "
        "less processor time than that, the latter). Differing: pixels more than 2/255 (linear) away "
        "from ours; Tachyon samples half a pixel off, so that edges and small things differ though the "
        "scene is the same. \"S4, point-sampled\": our checkers read at points, as POV-Ray's are; in "
        "\"S4\" ours are filtered over the pixel, so that the pictures differ there. "
        + about_mitsuba(there),
        table(compared(cases, scenes)),
        list(ratios(cases, [s for s in scenes if s != "S4"], labels))
        + ["The row S4, whose pictures differ, is not among them."],
        "## Soft shadows by the same number of shadow rays",
        "Ours takes 64 samples of a pixel, each of a camera ray and a shadow ray: its edges are "
        "antialiased. POV-Ray takes one camera ray and a fixed grid of 8 x 8 shadow rays: cheaper, and "
        "banded. So edges and penumbras differ; at equal error they are compared in "
        "docs/charts/soft_shadows.svg.",
        table(compared(cases, soft), ("RMSE from ours", lambda r: f"{r['rmse']:.4f}")),
        "## Our phases, seconds by the clock", phases(cases),
        "## Start-up: the trivial scene, 64x48", start,
        "Ours is mostly the loading of OpenImageIO, which writes the picture (startup.md). POV-Ray "
        "polls for its own end twice a second."
        + (" Mitsuba's is that of Python, and of compiling its kernel." if there else ""))
