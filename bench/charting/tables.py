"""The data of the charts: CSV files that say where their figures come from."""
import csv
import datetime
import platform
import statistics
import subprocess
import sys

from .programs import ROOT, Programs


def first_line(*command):
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return ""
    return next((line for line in (done.stdout + done.stderr).splitlines()
                 if any(c.isdigit() for c in line) and "cannot" not in line), "").strip()


def processor():
    with open("/proc/cpuinfo") as info:
        names = [line.split(":", 1)[1].strip() for line in info if line.startswith("model name")]
    return f"{names[0] if names else platform.machine()}, {len(names)} cores"


def circumstances(build, command, mitsuba=None):
    """Machine and versions, as the lines that head a data file. `mitsuba`: a Python that has it."""
    system = first_line("sh", "-c", ". /etc/os-release && echo $PRETTY_NAME")
    commit = first_line("git", "-C", str(ROOT), "rev-parse", "--short", "HEAD")
    with open("/proc/loadavg") as load:
        busy = load.read().split()[0]
    peers = [first_line("povray", "--version") if Programs.has("povray") else ""]
    if Programs.has("tachyon"):
        peers.append("Tachyon " + first_line("dpkg-query", "-W", "-f", "${Version}", "tachyon"))
    if mitsuba:
        peers.append("Mitsuba " + first_line(str(mitsuba), "-c",
                                             "import mitsuba; print(mitsuba.__version__)"))
    return [f"made by: {command}", f"date: {datetime.date.today()}",
            f"machine: {processor()}, {system}, load {busy} at the start",
            f"versions: {first_line(str(build / 'raytracer'), '--version')} ({commit}), "
            f"{first_line('c++', '--version')}" + "".join("; " + p for p in peers if p)]


def write(path, rows, heading):
    path.parent.mkdir(parents=True, exist_ok=True)
    names = list(dict.fromkeys(name for row in rows for name in row))
    with open(path, "w", newline="") as file:
        file.writelines(f"# {line}\n" for line in heading)
        writer = csv.DictWriter(file, names, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows({k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()}
                         for row in rows)


def value(word):
    try:
        return float(word)
    except ValueError:
        return word


def read(path):
    """The rows, numbers as numbers; and the heading."""
    with open(path, newline="") as file:
        lines = file.read().splitlines()
    heading = [line[2:] for line in lines if line.startswith("# ")]
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return [{k: value(v) for k, v in row.items()} for row in rows], heading


def stated(heading, name):
    return next((line.split(": ", 1)[1] for line in heading if line.startswith(name + ": ")), "")


def median_row(rows, *measured):
    """Rows of one case in several runs as one: medians, least and largest of what was measured."""
    out = {k: v for k, v in rows[0].items() if k not in measured}
    for name in measured:
        values = [row[name] for row in rows]
        out |= {name: statistics.median(values), name + "_min": min(values),
                name + "_max": max(values)}
    return out | {"runs": len(rows)}


def alternated(cases, runs, *measured):
    """Runs all cases in turn, `runs` times over, so that what slows the machine slows all. A case
    is a function that returns a row."""
    rounds = []
    for number in range(runs):
        rounds.append([case() for case in cases])
        print(f"  round {number + 1} of {runs}", file=sys.stderr)
    return [median_row(list(same), *measured) for same in zip(*rounds)]


def markdown(columns, rows):
    """A table. `columns`: heading and what makes a row's cell."""
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return lines + ["| " + " | ".join(str(cell(row)) for cell in columns.values()) + " |"
                    for row in rows]


def page(title, heading, *parts):
    """A file of bench/results: what it is, how it came to be, paragraphs and tables."""
    lines = [f"# {title}", "", *[f"{line}  " for line in heading]]
    for part in parts:
        lines += ["", *([part] if isinstance(part, str) else part)]
    return "\n".join(lines) + "\n"


def between(row, name, style="{:.3f}"):
    """A median and its spread, in words."""
    return " ".join([style.format(row[name]), "[" + style.format(row[name + "_min"]) + ",",
                     style.format(row[name + "_max"]) + "]"])
