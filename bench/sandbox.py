#!/usr/bin/env python3
"""What the sandbox costs honest scripts, and what a scene of a million nodes takes to load.

    cmake --preset bench && cmake --build --preset bench --target script_cost raytracer
    bench/sandbox.py build/bench > bench/results/sandbox.md

Costs are instructions of the processor, counted by valgrind (callgrind): they depend neither on the
machine's load nor on its clock. They do depend on Lua's seed for hashes, which is another in every
run and decides which names collide: the least of three runs counts. The start of the program is
counted alone and taken off. What a million nodes take is measured in processor time.
"""
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

SCENES = {
    "nodes: 50 000 spheres in a loop": """
local root, m = gr.node('root'), gr.material({0.7, 0.3, 0.2}, {0.2, 0.2, 0.2}, 20)
for i = 0, 49999 do
  local s = gr.sphere('s')
  s:set_material(m)
  s:scale(0.4, 0.4, 0.4)
  s:translate(i % 100, i // 100 % 100, i // 10000)
  root:add_child(s)
end""",
    "strings: names built and taken apart": """
local words = {}
for i = 1, 30000 do
  local name = 'part' .. i .. ':' .. ('x'):rep(i % 7)
  words[#words + 1] = name:gsub('%d', '#'):upper():sub(2, -2)
end
local all = table.concat(words, ',')
for word in all:gmatch('[^,]+') do assert(#word > 0) end""",
    "tables: a height field as mesh": """
local n, vertices, faces = 120, {}, {}
for j = 0, n do for i = 0, n do
  vertices[#vertices + 1] = {i, math.sin(i * 0.1) * math.cos(j * 0.1), j}
end end
for j = 0, n - 1 do for i = 0, n - 1 do
  local k = j * (n + 1) + i
  faces[#faces + 1] = {k, k + 1, k + n + 2, k + n + 1}
end end
gr.mesh('field', vertices, faces)""",
    "numbers: an orbit, no allocation": """
local x, y, s = 0.1, 0.2, 0
for i = 1, 1000000 do x, y = x * x - y * y + 0.3, 2 * x * y + 0.1
  if x * x + y * y > 4 then x, y = 0.1, 0.2 end s = s + x end""",
    # Each class has names of its own, so that no luck with their hashes decides.
    "objects: classes and closures": """
local text = [[
local Class = {} Class.__index = Class
local function new(v) return setmetatable({VALUE = v, GET = function() return v end}, Class) end
function Class:ADD(o) return new(self.VALUE + o:GET()) end
local sum = new(0)
for i = 1, 1500 do sum = sum:ADD(new(i)) end]]
for k = 1, 40 do
  load((text:gsub('%u%u+', function(name) return name:lower() .. k end)))()
end""",
    "objects: a class with methods that are used": """
local text = [[
local Vector = {} Vector.__index = Vector
local function vec(x, y, z) return setmetatable({XX = x, YY = y, ZZ = z}, Vector) end
function Vector.__add(a, b) return vec(a.XX + b.XX, a.YY + b.YY, a.ZZ + b.ZZ) end
function Vector.__mul(a, k) return vec(a.XX * k, a.YY * k, a.ZZ * k) end
function Vector:DOT(b) return self.XX * b.XX + self.YY * b.YY + self.ZZ * b.ZZ end
function Vector:LENGTH() return math.sqrt(self:DOT(self)) end
function Vector:UNIT() return self * (1 / self:LENGTH()) end
local p, v = vec(1, 0, 0), vec(0, 1, 0)
for i = 1, 500 do
  p = p + v * 0.01
  v = (v + p * (-0.01 / p:LENGTH() ^ 3)):UNIT()
end]]
for k = 1, 40 do
  load((text:gsub('%u%u+', function(name) return name:lower() .. k end)))()
end""",
}

MILLION = """
local root, m = gr.node('root'), gr.material({0.7, 0.3, 0.2}, {0.2, 0.2, 0.2}, 20)
for i = 0, 999999 do
  local s = gr.sphere('s')
  s:set_material(m)
  s:scale(0.4, 0.4, 0.4)
  s:translate(i % 100, i // 100 % 100, i // 10000)
  root:add_child(s)
end
gr.render(root, 'million.png', 64, 64, {50, 50, -200}, {0, 0, 1}, {0, 1, 0}, 40, {0.3, 0.3, 0.3},
          {gr.light({0, 200, -300}, {0.9, 0.9, 0.9}, {1, 0, 0})}, {samples = 1})
"""


def run(command, script):
    """Runs the command in a folder that holds the script as scene.lua."""
    with tempfile.TemporaryDirectory() as folder:
        with open(folder + "/scene.lua", "w", encoding="utf-8") as file:
            file.write(script)
        with open(folder + "/out", "w+", encoding="utf-8") as out:
            with subprocess.Popen(command, cwd=folder, stdout=out, stderr=out) as process:
                _, status, used = os.wait4(process.pid, 0)
                process.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0)
            text = out.read()
    if process.returncode != 0:
        sys.exit(text)
    return text, used


def callgrind(cost, mode, script):
    return ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", cost, mode, script]


def counted(text):
    return int(re.search(r"Collected : (\d+)", text).group(1))


def instructions(cost, mode, script):
    command = callgrind(cost, mode, "scene.lua")
    return min(counted(run(command, script)[0]) for _ in range(3))


def own_scripts(cost):
    """The project's scripts up to their first pictures: how many, and both modes' instructions. Those that
    need files or options, which script_cost has not, are left out."""
    root = pathlib.Path(__file__).resolve().parent.parent
    number, sums = 0, {"sandbox": 0, "trusted": 0}
    for script in sorted([*root.glob("scenes/*.lua"), *root.glob("tests/scripts/*.lua")]):
        if subprocess.run([cost, "sandbox", script], cwd=script.parent, capture_output=True,
                          check=False).returncode != 0:
            continue
        number += 1
        for mode in sums:
            texts = [subprocess.run(callgrind(cost, mode, script), cwd=script.parent, check=True,
                                    capture_output=True, text=True).stderr for _ in range(3)]
            sums[mode] += min(map(counted, texts))
    return number, sums


def costs(cost):
    print("# What the sandbox costs\n\nInstructions of the processor in millions, by callgrind "
          "(`bench/sandbox.py`), without the program's start. Plain is a\nLua state as the library "
          "gives it: `malloc` for every object, nothing counted, no `gr`.\n")
    print("| script | sandbox | `--trust` | plain | against `--trust` | against plain |\n"
          "|---|---|---|---|---|---|")
    modes = ["sandbox", "trusted", "plain"]
    start = {mode: instructions(cost, mode, "") for mode in modes}
    for name, script in SCENES.items():
        count = {mode: instructions(cost, mode, script) - start[mode]
                 for mode in modes if mode != "plain" or "gr." not in script}
        more = {mode: f"{100.0 * (count['sandbox'] / count[mode] - 1.0):+.2f}%" for mode in count}
        print(f"| {name} | {count['sandbox'] / 1e6:.1f} | {count['trusted'] / 1e6:.1f} "
              f"| {count.get('plain', 0) / 1e6:.1f} | {more['trusted']} "
              f"| {more.get('plain', '')} |".replace("| 0.0 |", "| |"), flush=True)
    number, sums = own_scripts(cost)
    print(f"\nThe {number} scripts of scenes/ and tests/scripts/ that need neither files nor options, each to "
          f"its first picture and with the opening\nof its Lua state: "
          f"{sums['sandbox'] / 1e6:.1f} million in the sandbox, {sums['trusted'] / 1e6:.1f} with "
          f"`--trust` ({100.0 * (sums['sandbox'] / sums['trusted'] - 1.0):+.2f}%). Without that opening, which is dearer with "
          f"all libraries: {(sums['sandbox'] - number * start['sandbox']) / 1e6:.1f} and "
          f"{(sums['trusted'] - number * start['trusted']) / 1e6:.1f}.")
    print("\nA script that has run for five seconds is counted from then on (a limit of 10^10 "
          "instructions), and then is a third slower; `--script-instructions` moves that point.")


def million(cost, program):
    loads = [run([cost, "sandbox", "scene.lua"], MILLION)[0].split() for _ in range(5)]
    wholes = [run([program, "scene.lua", "-q"], MILLION)[1] for _ in range(3)]
    print(f"""
# A million nodes, made by a loop

Processor seconds, user and system; median of {len(loads)} and {len(wholes)} runs. Most memory held.

| until | seconds | MB |
|---|---|---|
| the plan starts: script and snapshot, {loads[0][0]} shapes \
| {statistics.median(float(l[1]) for l in loads):.2f} | {max(int(l[2]) for l in loads)} |
| the end, with a picture of 64x64 \
| {statistics.median(w.ru_utime + w.ru_stime for w in wholes):.2f} \
| {max(w.ru_maxrss for w in wholes) // 1024} |""")


def main():
    build = os.path.realpath(sys.argv[1])
    costs(build + "/script_cost")
    million(build + "/script_cost", build + "/raytracer")


if __name__ == "__main__":
    main()
