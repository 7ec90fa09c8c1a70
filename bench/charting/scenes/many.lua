-- N balls and rings, each turned and placed by itself, in a cloud that keeps its look whatever N is:
-- many.lua -- N
local cloud = require "cloud"
local random, n = cloud.random, tonumber(arg[1])
local edge = 4 / n ^ (1 / 3)
local root = gr.node("root")
for i = 1, n do
  local shape = i % 2 == 0 and gr.torus("ring") or gr.sphere("ball")
  shape:set_material(gr.material {kd = {random(), random(), random()}})
  shape:scale(0.25 * edge, 0.25 * edge, 0.25 * edge):rotate("x", 360 * random())
  root:add_child(cloud.place(shape))
end
cloud.render(root, "many.png")
