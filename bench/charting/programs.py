"""Runs of this program and of its peers: pinned to one processor, one thread, timed by their own
statistics."""
import functools
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass, field

import numpy as np

from . import pictures

ROOT = pathlib.Path(__file__).resolve().parents[2]


# Runs a command and writes down what it took. A process' largest memory counts from before its
# exec: were the command started from here, it would have at least what NumPy takes.
WAITER = """
import json, os, sys, time
begin = time.monotonic()
pid = os.posix_spawnp(sys.argv[2], sys.argv[2:], os.environ)
_, status, usage = os.wait4(pid, 0)
wall = time.monotonic() - begin
open(sys.argv[1], "w").write(json.dumps([usage.ru_utime, wall, usage.ru_maxrss]))
sys.exit(os.waitstatus_to_exitcode(status) and 1)
"""


@dataclass
class Run:
    """One run. Seconds of tracing, of the process (user time), and by the clock."""
    trace: float
    user: float
    wall: float
    memory: int  # bytes, at most
    picture: np.ndarray = None
    stats: dict = field(default_factory=dict)
    all: list = field(default_factory=list)  # statistics of every picture of a script


class Programs:
    """Where the programs are and where they write."""

    def __init__(self, build, scratch, cache, cpu):
        self.build, self.scratch, self.cache = map(pathlib.Path, (build, scratch, cache))
        self.pin = ["taskset", "-c", str(cpu)] if shutil.which("taskset") else []
        self.scratch.mkdir(parents=True, exist_ok=True)
        self.cache.mkdir(parents=True, exist_ok=True)

    @functools.cached_property
    def peers(self):
        """A folder of the scenes of bench/scenes, as others read them."""
        folder = self.scratch / "peers"
        subprocess.run([ROOT / "bench/peers.py", folder], check=True)
        return folder

    def best(self, name):
        """A program of ours, compiled for the best this processor runs, as the launcher chooses."""
        flags = set(re.search(r"^flags\s*:(.*)$", pathlib.Path("/proc/cpuinfo").read_text(),
                              re.MULTILINE)[1].split())
        v4 = self.build / f"{name}-v4"
        wide = {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"} <= flags
        return v4 if wide and v4.exists() else self.build / name

    @staticmethod
    def has(name):
        return shutil.which(name) is not None

    def timed(self, command):
        """Output and error text, user and wall seconds, memory of a pinned process."""
        figures = self.scratch / "figures.json"
        done = subprocess.run([sys.executable, "-S", "-E", "-c", WAITER, figures, *self.pin,
                               *map(str, command)], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, cwd=self.scratch)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, command))}\n{done.stdout}")
        user, wall, memory = json.loads(figures.read_text())
        return done.stdout, user, wall, memory * 1024

    def raytracer(self, scene, *options, threads=1, picture=True):
        """`scene` may carry arguments for the script: [path, argument...]."""
        scene, *arguments = scene if isinstance(scene, list) else [scene]
        out, stats = self.scratch / "own.exr", self.scratch / "own.json"
        command = [self.build / "raytracer", scene, "-o", out, "-q", "-t", threads, "--stats", stats,
                   *options] + (["--", *arguments] if arguments else [])
        _, user, wall, memory = self.timed(command)
        all_told = json.loads(stats.read_text())["pictures"]
        told = all_told[0]
        return Run(told["seconds"]["trace_cpu"], user, wall, memory,
                   pictures.read(out) if picture else None, told, all_told)

    def render_only(self, scene, size, *words):
        """What bench/economy/render_only says, by name; and the process' largest memory."""
        said, _, _, memory = self.timed([self.build / "render_only", scene, size, *words])
        names = ("digest", "build", "trace", "rays", "shapes", "script_bytes", "plan_bytes", "script")
        told = dict(zip(names, said.split()))
        return {k: v if k == "digest" else float(v) for k, v in told.items()} | {"memory": memory}

    def povray(self, scene, size, *options):
        """Values are linear: the files of bench/peers.py say assumed_gamma 1."""
        out = self.scratch / "povray.ppm"
        out.unlink(missing_ok=True)
        said, user, wall, memory = self.timed(
            ["povray", f"+I{self.peers / scene}.pov", f"+O{out}", "+FP16", f"+W{size[0]}",
             f"+H{size[1]}", "-D", "-V", "+WT1", "File_Gamma=1.0", *(options or ["-A"])])
        trace = re.search(r"Trace Time:.*?with\s+([0-9.]+) CPU-seconds", said, re.S)
        rays = sum(int(n) for n in re.findall(r"^(?:Rays|Shadow Ray Tests):\s+(\d+)", said, re.M))
        return Run(float(trace.group(1)), user, wall, memory, pictures.read(out), {"rays": rays})

    def tachyon(self, scene, size):
        """Its own statement is wall time, which a busy machine makes longer: the time of tracing is
        never more than the processor time of the process."""
        out = self.scratch / "tachyon.ppm"
        said, user, wall, memory = self.timed(
            ["tachyon", self.peers / f"{scene}.tachyon.dat", "-numthreads", "1", "-res", size[0],
             size[1], "-format", "PPM48", "-o", out])
        stated = float(re.search(r"Ray Tracing Time:\s+([0-9.]+)", said).group(1))
        return Run(min(stated, user), user, wall, memory, pictures.read(out), {"stated": stated})

    @functools.cached_property
    def mitsuba_python(self):
        """A Python that can render with Mitsuba; None where there is none."""
        given = os.environ.get("MITSUBA_PYTHON")
        usual = pathlib.Path.home() / ".local/share/raytracer/mitsuba/bin/python"
        test = "import mitsuba as m, drjit; m.set_variant('llvm_ad_rgb'); drjit.eval(m.Float(1) + 1)"
        for python in [given] if given else [usual, shutil.which("python3")]:
            if python and os.access(python, os.X_OK) and subprocess.run(
                    [python, "-c", test], capture_output=True, check=False).returncode == 0:
                return python
        return None

    def mitsuba(self, scene, size, samples=1, passes=1, seed=0):
        """The compiling of its kernel is not counted as tracing."""
        out = self.scratch / "mitsuba.pfm"
        said, user, wall, memory = self.timed(
            [self.mitsuba_python, ROOT / "bench/mitsuba_peer.py", scene, f"{size[0]}x{size[1]}",
             samples, passes, seed, out])
        told = json.loads(said.splitlines()[-1])
        return Run(told["trace"], user, wall, memory, pictures.read(out), told)

    def reference(self, key, *makers):
        """The mean of independent pictures, and the error of that mean; kept between runs."""
        name = hashlib.sha256(repr(key).encode()).hexdigest()[:16]
        file = self.cache / f"{name}.npy"
        if not file.exists():
            np.save(file, np.stack([make() for make in makers]))
        parts = np.load(file)
        error = pictures.rmse(parts[0], parts[1]) / 2 if len(parts) == 2 else float("nan")
        return parts.mean(axis=0), error
