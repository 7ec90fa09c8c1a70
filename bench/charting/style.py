"""How a chart looks."""
import math
import textwrap

import matplotlib
from matplotlib import ticker

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

# Okabe and Ito's colours, which colour-blind people can tell apart.
OWN, POVRAY, TACHYON = "#0072B2", "#D55E00", "#009E73"
PINK, YELLOW, SKY, GREY = "#CC79A7", "#E69F00", "#56B4E9", "#777777"
BLACK = "#000000"
COLOURS = [OWN, POVRAY, TACHYON, PINK, YELLOW, SKY, GREY, BLACK]
MARKS = "os^DvPX*"

plt.rcParams.update({
    "font.size": 9, "axes.titlesize": 11, "axes.titleweight": "bold", "axes.titlelocation": "left",
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "axes.axisbelow": True,
    "grid.color": "#dddddd", "grid.linewidth": 0.6, "lines.linewidth": 1.6, "lines.markersize": 5,
    "legend.frameon": False, "figure.facecolor": "white", "svg.hashsalt": "charts",
    "svg.fonttype": "path"})


def sheet(columns=1, width=7.2, height=4.4):
    figure, axes = plt.subplots(1, columns, figsize=(width, height), squeeze=False)
    return figure, list(axes[0])


def spread(row, name):
    """Distances of the least and the largest from the median, for errorbar()."""
    return [[row[name] - row[name + "_min"]], [row[name + "_max"] - row[name]]]


def line(axes, rows, x, y, label, index, **more):
    """A series with the spread of its x, which is a time."""
    rows = sorted(rows, key=lambda row: row[x])
    colour = more.pop("color", COLOURS[index % len(COLOURS)])
    axes.plot([r[x] for r in rows], [r[y] for r in rows], MARKS[index % len(MARKS)] +
              more.pop("dash", "-"), color=colour, label=label, **more)
    for row in rows:
        if x + "_min" in row:
            axes.errorbar(row[x], row[y], xerr=spread(row, x), color=colour, linewidth=0.8,
                          capsize=1.5)


def log_log(axes, x, y, title=""):
    """To be called when everything is drawn: the ticks depend on it."""
    axes.set(xscale="log", yscale="log", xlabel=x, ylabel=y, title=title)
    plain_ticks(axes)


def decimal(x, _):
    """1 rather than 10^0, but 10^-7 rather than 0.0000001."""
    if 1e-4 <= x <= 99_999:
        return f"{x:g}"
    exponent = round(math.log10(x))
    return f"$10^{{{exponent}}}$" if math.isclose(x, 10.0 ** exponent) else f"{x:.0e}"


def plain_ticks(axes):
    for axis in (axes.xaxis, axes.yaxis):
        plain_ticks_of(axis)


def plain_ticks_of(axis):
    """Decades, or 1, 2, 5 where there are few of them."""
    low, high = sorted(axis.get_view_interval())
    decades = math.log10(high / low)
    axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5) if decades < 2.3 else (1,), numticks=12))
    axis.set_major_formatter(ticker.FuncFormatter(decimal))
    axis.set_minor_locator(ticker.NullLocator())


def save(figure, path, note, title=""):
    """`note` goes below the chart; `title` above it where several panels have titles of their own."""
    columns = int(19.5 * figure.get_figwidth())
    note = "\n".join(textwrap.fill(line, columns) for line in note.splitlines())
    inch = 1 / figure.get_figheight()
    figure.text(0.012, 0.06 * inch, note, fontsize=6.5, color="#555555", va="bottom")
    if title:
        figure.text(0.012, 1 - 0.08 * inch, title, fontsize=12, fontweight="bold", va="top")
    lines = note.count("\n") + 1
    figure.tight_layout(rect=(0, (0.1 + 0.115 * lines) * inch, 1, 1 - (0.3 * inch if title else 0)))
    path.parent.mkdir(parents=True, exist_ok=True)
    # No date, so that the same data give the same bytes.
    figure.savefig(path, metadata={"Date": None} if path.suffix == ".svg" else None, dpi=110)
    plt.close(figure)
