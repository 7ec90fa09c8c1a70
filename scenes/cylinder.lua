-- Cylinders: radius 1 about the y axis, from y = 0 to 1, closed by discs. A small temple.
local marble = gr.material({0.82, 0.8, 0.75}, {0.25, 0.25, 0.25}, 40)
local roof = gr.material({0.6, 0.25, 0.15}, {0.1, 0.1, 0.1}, 10)
local grass = gr.material({0.3, 0.42, 0.2}, {0, 0, 0}, 1)

local scene = gr.node("scene")
scene:set_material(marble)

local function drum(name, radius, height, y)
  local node = gr.cylinder(name)
  node:scale(radius, height, radius):translate(0, y, 0)
  scene:add_child(node)
  return node
end

drum("step1", 2.3, 0.15, 0)
drum("step2", 2.1, 0.15, 0.15)
for i = 0, 7 do
  local angle = math.rad(45 * i + 20)
  local column = gr.cylinder("column" .. i)
  column:scale(0.2, 2, 0.2):translate(1.6 * math.cos(angle), 0.3, 1.6 * math.sin(angle))
  scene:add_child(column)
end
drum("architrave", 2, 0.2, 2.3)
for i = 0, 9 do
  drum("roof" .. i, 1.9 - 0.19 * i, 0.08, 2.5 + 0.08 * i):set_material(roof)
end

local ground = gr.plane("ground")
ground:set_material(grass)
scene:add_child(ground)

gr.render(scene, "cylinder.png", 512, 512,
  {0, 2.6, 8.5}, {0, -0.13, -1}, {0, 1, 0}, 38,
  {0.28, 0.28, 0.32},
  {gr.light({6, 7, 6}, {0.8, 0.77, 0.7}, {1, 0, 0})},
  {background = {top = {0.25, 0.42, 0.75}, bottom = {0.82, 0.88, 0.93}}})
