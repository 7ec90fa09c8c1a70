"""Rays per second against bare Embree's, on the same rays."""
import csv
import subprocess

from . import curves, style, tables

NAME, TITLE = "rays", "Our rays per second over bare Embree's"
ASKED = 0.6


# Primitives, the picture's edge, rounds: what is charted; then a thousand and a million, through as many
# pixels as 320x240 and 1280x960 have.
CHARTED = (100_000, 512, 7)
GROWTH = tuple((count, edge, 3) for edge in (277, 1109) for count in (1000, 1_000_000))
QUICK = ((2000, 64, 1), (500, 32, 1), (4000, 32, 1))


def measure(context):
    rows = []
    for count, edge, rounds in QUICK if context.quick else (CHARTED, *GROWTH):
        rows += measured(context, count, edge, rounds)
    return {NAME: rows}


def measured(context, count, edge, rounds):
    said = subprocess.run([*context.programs.pin, context.programs.best("bench_rays"), str(count),
                           str(edge), str(rounds)], check=True, capture_output=True, text=True)
    rows = [{k: v if k in ("subject", "kind") else float(v) for k, v in row.items()}
            for row in csv.DictReader(said.stdout.splitlines())]
    found = {}
    for row in rows:
        if row["agreeing"] < 0.999:
            raise RuntimeError(f"{row['subject']}, {row['kind']}: hits agree on {row['agreeing']:%}")
        row |= {"edge": edge, "ratio": row["own"] / row["embree"]}
        found.setdefault((row["subject"], row["kind"]), []).append(row)
    return [tables.median_row(same, "own", "embree", "ratio") for same in found.values()]


def charted(data):
    return [r for r in data[NAME] if r["edge"] == data[NAME][0]["edge"]]


def growths(data):
    """How many times as long a ray takes among the most primitives as among the fewest: pairs of
    rows."""
    cases = {}
    for row in data[NAME][len(charted(data)):]:
        cases.setdefault((row["subject"], row["edge"], row["kind"]), []).append(row)
    return [(rows[0], rows[-1]) for rows in cases.values()]


def draw(data):
    figure, (axes,) = style.sheet(height=3.2)
    shown = charted(data)
    kinds = list(curves.series(shown, "kind"))[::-1]
    for shift, (subject, rows), colour in zip((0.2, -0.2), curves.series(shown, "subject").items(),
                                              (style.OWN, style.TACHYON)):
        places = [kinds.index(r["kind"]) + shift for r in rows]
        bars = axes.barh(places, [r["ratio"] for r in rows], 0.38, color=colour,
                         xerr=[[r["ratio"] - r["ratio_min"] for r in rows],
                               [r["ratio_max"] - r["ratio"] for r in rows]],
                         error_kw={"elinewidth": 0.8, "capsize": 2},
                         label=f"{rows[0]['primitives']:,.0f} " +
                         ("balls" if subject == "balls" else "triangles"))
        axes.bar_label(bars, [f"{r['own'] / 1e6:.1f} M/s" for r in rows], padding=12, fontsize=8)
    axes.axvline(ASKED, color=style.GREY, linewidth=0.9, linestyle=":")
    axes.axvline(1, color=style.GREY, linewidth=0.9)
    axes.set(yticks=range(len(kinds)), yticklabels=kinds, title=TITLE,
             xlabel="our rays per second / Embree's")
    axes.set_xlim(0, max(1.15, axes.get_xlim()[1] * 1.15))
    axes.grid(axis="y", visible=False)
    axes.legend(fontsize=8)
    return figure, ("Single rays, one thread, in turns; labels: ours. Dotted: aimed at. Embree finds "
                    "triangles in single precision, balls in leaves of ours in double precision, "
                    "and starts a little off the surface it leaves; ours "
                    "finds all in double precision, and knows what it leaves. bench/rays.")


def report(data, heading):
    shown = charted(data)
    worst = min(r["ratio"] for r in shown)
    table = tables.markdown({
        "scene": lambda r: f"{r['primitives']:,.0f} {r['subject']}", "rays": lambda r: r["kind"],
        "ours, M/s": lambda r: tables.between({k: v / 1e6 for k, v in r.items()
                                               if k.startswith("own")}, "own", "{:.2f}"),
        "Embree, M/s": lambda r: f"{r['embree'] / 1e6:.2f}",
        "ours / Embree": lambda r: tables.between(r, "ratio", "{:.2f}"),
        "agreeing": lambda r: f"{100 * r['agreeing']:.4f}%"}, shown)

    def grown(pair, whose):
        few, many = (1e9 / row[whose] for row in pair)
        return f"{few:.0f} to {many:.0f}, {many / few:.2f} times"
    growth = tables.markdown({
        "scene": lambda p: f"{p[0]['primitives']:,.0f} to {p[1]['primitives']:,.0f} {p[0]['subject']}",
        "rays": lambda p: f"{p[0]['kind']}, through {p[0]['edge']:.0f}x{p[0]['edge']:.0f} pixels",
        "ours, ns": lambda p: grown(p, "own"), "Embree, ns": lambda p: grown(p, "embree")},
        growths(data))
    return NAME + ".md", tables.page(
        "Rays per second against bare Embree", heading,
        "bench/rays: the same single rays, one thread, medians of rounds in turns. Embree: "
        "rtcIntersect1 and rtcOccluded1, robust scene of high build quality, native triangles, "
        "user geometry with double-precision leaves for balls, "
        "nothing of ours about them. Ours: closest_hit() and occluded(), one ray at a time, and "
        "closest_hits() for packets of the camera's, "
        "without what the renderer keeps of a pixel's "
        "neighbourhood. Agreeing: rays of which both say the same.", table,
        f"Aimed at: {ASKED:g} everywhere. The least is {worst:.2f}: "
        + ("reached." if worst >= ASKED else "not reached."),
        "How the time of a ray grows with the scene, medians of three rounds:", growth)
