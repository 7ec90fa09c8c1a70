"""How long it takes to begin and end: a trivial scene, help, and errors, by the clock."""
import re
import subprocess

from . import tables
from .programs import ROOT

NAME, TITLE = "startup", "Start-up, by the clock"
ABOVE_LIBRARY, ASKED = 0.030, 0.030  # aimed at, seconds


def library(context):
    """OpenImageIO's file, as the module that uses it is linked."""
    said = subprocess.run(["ldd", context.build / "rt_oiio.so"], capture_output=True, text=True,
                          check=True).stdout
    return re.search(r"libOpenImageIO\.so\S* => (\S+)", said).group(1)


def failing_scene(context, name, text):
    file = context.programs.scratch / name
    file.write_text(text)
    return file


def commands(context):
    """What is run, and the exit code it should end with."""
    program, out = context.build / "raytracer", context.programs.scratch / "startup.png"
    trivial = ROOT / "bench/scenes/trivial.lua"
    misspelt = failing_scene(context, "misspelt.lua", "gr.spheer('x')\n")
    return {
        "OpenImageIO loaded, alone": ([context.build / "time_dlopen", library(context)], 0),
        "trivial scene, 64x48": ([program, trivial, "-o", out, "-q"], 0),
        "--help": ([program, "--help"], 0),
        "--version": ([program, "--version"], 0),
        "no such file": ([program, "nowhere.lua"], None),
        "a misspelt function": ([program, misspelt], None),
        "a misspelt option": ([program, trivial, "--sampels", "4"], None)}


def case_of(context, name, command, code):
    script = ["import os, sys, time", "begin = time.monotonic()",
              "null = os.open(os.devnull, os.O_WRONLY)",
              "pid = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ, file_actions="
              "[(os.POSIX_SPAWN_DUP2, null, 1), (os.POSIX_SPAWN_DUP2, null, 2)])",
              "_, status, usage = os.wait4(pid, 0)",
              "print(time.monotonic() - begin, usage.ru_utime + usage.ru_stime, "
              "os.waitstatus_to_exitcode(status))"]

    def case():
        said = subprocess.run(["/usr/bin/python3", "-S", "-E", "-c", "\n".join(script),
                               *map(str, command)], capture_output=True, text=True, check=True,
                              cwd=context.programs.scratch).stdout.split()
        wall, processor, ended = float(said[0]), float(said[1]), int(said[2])
        if (ended != code) if code is not None else ended <= 0:
            raise RuntimeError(f"{name}: ended with {ended}")
        return {"what": name, "wall": wall, "processor": processor, "exit": ended}
    return case


def measure(context):
    cases = [case_of(context, name, *rest) for name, rest in commands(context).items()]
    runs = 2 if context.quick else 21
    return {NAME: tables.alternated(cases, runs, "wall", "processor")}


def report(data, heading):
    rows = {r["what"]: r for r in data[NAME]}
    loaded = rows["OpenImageIO loaded, alone"]["wall"]

    def aim(row):
        if row["what"].startswith("OpenImageIO"):
            return ""
        limit = loaded + ABOVE_LIBRARY if row["what"].startswith("trivial") else ASKED
        return f"{1e3 * limit:.0f}: " + ("reached" if row["wall"] <= limit else "**not reached**")
    table = tables.markdown({
        "": lambda r: r["what"],
        "wall, ms [least, largest]": lambda r: tables.between(
            {k: 1e3 * v for k, v in r.items() if k.startswith("wall")}, "wall", "{:.1f}"),
        "processor, ms": lambda r: f"{1e3 * r['processor']:.1f}",
        "exit code": lambda r: f"{r['exit']:.0f}", "at most, ms": aim}, data[NAME])
    return NAME + ".md", tables.page(
        TITLE, heading, "Whole processes on all processors, everything in the disk's cache, medians of "
        f"{data[NAME][0]['runs']:.0f} runs in turns. Loading OpenImageIO alone: a program that opens "
        f"the library and ends. The trivial scene may take {1e3 * ABOVE_LIBRARY:.0f} ms more than that, "
        "since it writes a picture.", table)
