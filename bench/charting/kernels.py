"""The innermost pieces, by Google Benchmark."""
import json
import subprocess

from . import tables

NAME, TITLE = "kernels", "Kernels"


def measure(context):
    program = context.build / "bench_kernels"
    if not program.exists():
        return {NAME: [{"kernel": "not built: Google Benchmark is missing", "ns": "", "runs": 0}]}
    repetitions, seconds = (1, 0.01) if context.quick else (5, 0.1)
    said = subprocess.run(
        [*context.programs.pin, program, "--benchmark_format=json",
         f"--benchmark_min_time={seconds}", f"--benchmark_repetitions={repetitions}",
         "--benchmark_enable_random_interleaving=true"],
        check=True, capture_output=True, text=True).stdout
    found = {}
    for run in json.loads(said)["benchmarks"]:
        if run["run_type"] == "iteration":
            found.setdefault(run["name"], []).append(
                {"kernel": run["name"], "ns": run["cpu_time"], "hits": run.get("hits", "")})
    return {NAME: [tables.median_row(same, "ns") for _, same in sorted(found.items())]}


def report(data, heading):
    measured = [r for r in data[NAME] if r["ns"] != ""]
    table = tables.markdown({
        "kernel": lambda r: r["kernel"],
        "ns [least, largest]": lambda r: tables.between(r, "ns", "{:.1f}"),
        "share of rays that hit": lambda r: f"{r['hits']:.2f}" if r["hits"] != "" else ""},
        measured) if measured else "Not measured: Google Benchmark is missing."
    return NAME + ".md", tables.page(
        TITLE, heading, "bench/kernels: processor time of one call, 4096 different arguments in turn; "
        "rays come from all sides, aimed at points of the shape's box and somewhat beyond.", table)
