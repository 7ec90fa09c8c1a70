"""What a thousand times as many primitives cost: time a ray, building, memory."""
from . import curves, style, tables
from .programs import ROOT

NAME, TITLE = "scaling", "From a thousand to a million primitives"
SCENES = {"balls and rings": ROOT / "bench/charting/scenes/many.lua",
          "a mesh's triangles": ROOT / "bench/charting/scenes/sheet.lua",
          "instances of a mesh": ROOT / "bench/charting/scenes/crowd.lua"}
GROWTH, BUILD, BYTES = 3, 3, 200  # aimed at: times, seconds, bytes a primitive
# As many samples as the default error wants, or one a pixel. A million things are 13 a pixel of the
# smallest, each met by at most a few rays, one of the second, a fifth of one of the third.
PICTURES = (("320x240", "adaptive"), ("320x240", "one"), ("1280x960", "one"), ("2560x1920", "one"))


def case_of(context, label, count, size, samples):
    def case():
        told = context.programs.render_only(SCENES[label], size, "--", count, samples)
        how = "default samples" if samples == "adaptive" else "one sample"
        return {"series": f"{label}, {size}, {how}", "primitives": count, "size": size,
                "ns_per_ray": 1e9 * told["trace"] / told["rays"], "build": told["build"],
                "script": told["script"], "bytes": told["plan_bytes"] / count,
                "script_bytes": told["script_bytes"] / count, "rays": told["rays"],
                "peak": told["memory"]}
    return case


def measure(context):
    counts = (1000, 4000) if context.quick else (1000, 10_000, 100_000, 1_000_000)
    cases = [case_of(context, label, count, *picture) for count in counts for label in SCENES
             for picture in ((("80x60", "one"),) if context.quick else PICTURES)]
    return {NAME: tables.alternated(cases, context.runs, "ns_per_ray", "build", "script")}


def draw(data):
    figure, panels = style.sheet(3, width=9.6, height=3.6)
    for axes, y, title, label in zip(panels, ("ns_per_ray", "build", "bytes"),
                                     ("Time a ray", "Building", "Memory"),
                                     ("ns", "processor time, s", "bytes a primitive")):
        shown = curves.series(data[NAME])
        each = len(shown) // len(SCENES)
        for index, (name, rows) in enumerate(shown.items()):
            if y != "ns_per_ray" and index % each > 0:
                continue  # as good as the same for all pictures
            axes.plot([r["primitives"] for r in rows], [r[y] for r in rows],
                      style.MARKS[index // each] + ("-", "--", ":", "-.")[index % each],
                      label=name.split(",")[0] if index % each == 0 else None,
                      color=style.COLOURS[index // each])
        style.log_log(axes, "primitives", label, title)
    panels[1].axhline(BUILD, color=style.GREY, linewidth=0.8, linestyle=":")
    panels[2].axhline(BYTES, color=style.GREY, linewidth=0.8, linestyle=":")
    panels[1].legend(fontsize=7.5, loc="upper left")
    return figure, ("Building: compiling the scene that the script has made; memory: what that "
                    "allocates beyond the script's own. Grey: aimed at. "
                    f"{pictures(data)}; medians of {data[NAME][0]['runs']:.0f} runs.")


def pictures(data):
    """What the lines are, in words."""
    names = [rows[0]["series"].split(", ", 1)[1] for rows in curves.series(data[NAME]).values()]
    kinds = names[:len(names) // len(SCENES)]
    return "; ".join(f"{line}: {kind}" for line, kind in zip(
        ("solid", "dashed", "dotted", "dashes and dots"), kinds))


def verdict(rows):
    first, last = rows[0], rows[-1]
    growth = last["ns_per_ray"] / first["ns_per_ray"]
    facts = [(f"time a ray grows {growth:.2f} times (below {GROWTH})", growth < GROWTH),
             (f"building takes {last['build']:.2f} s (below {BUILD})", last["build"] < BUILD),
             (f"{last['bytes']:.0f} bytes a primitive (below {BYTES})", last["bytes"] < BYTES)]
    return "; ".join(text + (": reached" if held else ": **not reached**") for text, held in facts)


def report(data, heading):
    table = tables.markdown({
        "scene": lambda r: r["series"], "primitives": lambda r: f"{r['primitives']:,.0f}",
        "ns a ray": lambda r: tables.between(r, "ns_per_ray", "{:.0f}"),
        "rays": lambda r: f"{r['rays']:,.0f}",
        "building, s": lambda r: f"{r['build']:.3f}", "script, s": lambda r: f"{r['script']:.3f}",
        "bytes a primitive": lambda r: f"{r['bytes']:.0f}",
        "the script's own": lambda r: f"{r['script_bytes']:.0f}",
        "peak, MB": lambda r: f"{r['peak'] / 1e6:.0f}"}, data[NAME])
    found = [f"- {name}, {rows[0]['primitives']:,.0f} to {rows[-1]['primitives']:,.0f}: "
             + verdict(rows) + "." for name, rows in curves.series(data[NAME]).items()]
    return NAME + ".md", tables.page(
        TITLE, heading, "Processor time, one thread; of samples' rays and their shadow rays. Bytes: "
        "allocated when the plan has been made, less what was allocated before; the script's own: "
        "allocated when it has ended. Scenes: many.lua, sheet.lua, crowd.lua in bench/charting/scenes.", table, found)
