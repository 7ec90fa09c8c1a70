#!/usr/bin/env python3
"""What the sandbox costs honest scripts: instructions executed with it and with --trust.

    bench/sandbox.py build/release/raytracer > bench/results/sandbox.md

Counted by valgrind (callgrind), so the figures depend neither on the machine's load nor on its
clock. The scripts make no picture: all that runs is start, script and end; the start is counted
alone and taken off. Under valgrind a script takes fifty times as long; --script-instructions is
raised in proportion, so that counting begins when it would.
"""
import re
import subprocess
import sys
import tempfile

SCENES = {
    "nodes: 100 000 spheres in a loop": """
local root, m = gr.node('root'), gr.material({0.7, 0.3, 0.2}, {0.2, 0.2, 0.2}, 20)
for i = 0, 99999 do
  local s = gr.sphere('s')
  s:set_material(m)
  s:scale(0.4, 0.4, 0.4)
  s:translate(i % 100, i // 100 % 100, i // 10000)
  root:add_child(s)
end""",
    "strings: names built and taken apart": """
local words = {}
for i = 1, 60000 do
  local name = 'part' .. i .. ':' .. ('x'):rep(i % 7)
  words[#words + 1] = name:gsub('%d', '#'):upper():sub(2, -2)
end
local all = table.concat(words, ',')
for word in all:gmatch('[^,]+') do assert(#word > 0) end""",
    "tables: a height field as mesh": """
local n, vertices, faces = 150, {}, {}
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
for i = 1, 3000000 do x, y = x * x - y * y + 0.3, 2 * x * y + 0.1
  if x * x + y * y > 4 then x, y = 0.1, 0.2 end s = s + x end""",
    "objects: classes and closures": """
local Class = {} Class.__index = Class
local function new(v) return setmetatable({v = v, get = function() return v end}, Class) end
function Class:add(o) return new(self.v + o:get()) end
local sum = new(0)
for i = 1, 100000 do sum = sum:add(new(i)) end""",
}
# How many cycles the collector makes depends on how much the libraries took before; so once more
# without it.
SCENES["the same, collector stopped"] = (
    "collectgarbage('stop')" + SCENES["objects: classes and closures"])


def instructions(program, script, flags):
    with tempfile.TemporaryDirectory() as folder:
        with open(folder + "/scene.lua", "w", encoding="utf-8") as file:
            file.write(script)
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program, "scene.lua",
             "-q"] + flags, cwd=folder, capture_output=True, text=True, check=False)
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 1 or "made no picture" not in run.stderr or not found:
        sys.exit(run.stderr)
    return int(found.group(1))


def main():
    program = subprocess.run(["realpath", sys.argv[1]], capture_output=True, text=True,
                             check=True).stdout.strip()
    modes = {"sandbox": ["--script-time", "3000", "--script-instructions", "500000000000"],
             "trusted": ["--trust"]}
    start = {mode: instructions(program, "", flags) for mode, flags in modes.items()}
    print("# What the sandbox costs\n\nInstructions of the processor in millions, by callgrind "
          "(`bench/sandbox.py`), without the program's start.\n")
    print("| script | sandbox | `--trust` | more |\n|---|---|---|---|")
    for name, script in SCENES.items():
        count = {mode: instructions(program, script, flags) - start[mode]
                 for mode, flags in modes.items()}
        more = 100.0 * (count["sandbox"] / count["trusted"] - 1.0)
        print(f"| {name} | {count['sandbox'] / 1e6:.1f} | {count['trusted'] / 1e6:.1f} "
              f"| {more:+.2f}% |", flush=True)
    print("\nA script that has run for five seconds is counted from then on (a limit of 10^10 "
          "instructions), and then is a third slower; `--script-instructions` moves that point.")


if __name__ == "__main__":
    main()
