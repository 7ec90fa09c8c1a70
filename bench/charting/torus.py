"""Solvers of the torus' quartic: time against failures, by family of rays."""
import subprocess

from . import curves, style

NAME, TITLE = "torus", "Torus solvers: time against failures and error"
TABLES = {"ns per ray": "ns", "missed per million": "missed", "false per million": "false",
          "error / R": "error"}


def parsed(markdown):
    """bench_stability's tables of the torus, one row a family and method."""
    found, key, names = {}, None, []
    for line in markdown.splitlines():
        cells = [c.strip() for c in line.strip().strip("|").split("|")]
        if line.startswith("## Every shape"):
            break
        if cells[0] in TABLES:
            key, names = TABLES[cells[0]], cells[1:]
        elif not line.startswith("|"):
            key = None
        elif key and cells[0] != "---":
            for name, cell in zip(names, cells[1:]):
                row = found.setdefault((cells[0], name), {"family": cells[0], "method": name})
                outright, _, below = cell.replace(")", "").partition(" (")
                row[key] = float(outright)
                if key in ("missed", "false"):
                    row[key + "_below_resolution"] = float(below or 0)
    return list(found.values())


def measure(context):
    rays, others = (200, 100) if context.quick else (20_000, 5_000)
    said = subprocess.run(
        context.programs.pin + [context.build / "bench_stability", "--rays", str(rays),
                                "--other-rays", str(others), "--secondary", "0", "--threads", str(context.threads)],
        check=True, capture_output=True, text=True).stdout
    return {NAME: [row | {"rays": rays if "this program" in row["method"] else others}
                   for row in parsed(said)]}


def draw(data):
    figure, panels = style.sheet(2, width=9, height=4.8)
    for index, (name, points) in enumerate(curves.series(data[NAME], "method").items()):
        x = [p["ns"] for p in points]
        # Nothing found among N rays is drawn at a third of one in N: below what could be seen.
        wrong = [max(p["missed"] + p["false"], 1e6 / p["rays"] / 3) for p in points]
        for axes, y in zip(panels, (wrong, [p["error"] for p in points])):
            axes.plot(x, y, style.MARKS[index], color=style.COLOURS[index], label=name, alpha=0.8)
    style.log_log(panels[0], "ns per ray", "missed and false, per million rays", "Failures")
    style.log_log(panels[1], "ns per ray", "largest error of a hit / R", "Errors")
    panels[0].legend(fontsize=7.5)
    own = [p for p in data[NAME] if p["method"] == "this program"]
    return figure, (f"One mark a family of rays ({len(own)}: random, grazing, thin, far, double root"
                    " ...). No failure is drawn at a third of one among the rays tried "
                    f"({own[0]['rays']:.0f} of this program's a family, "
                    f"{min(p['rays'] for p in data[NAME]):.0f} of the others'). bench/stability.")
