-- Cubes: gr.cube is [0,1]^3, gr.nh_box takes its least corner and its size.
local wood = gr.material({0.7, 0.5, 0.3}, {0.2, 0.2, 0.2}, 30)
local slate = gr.material({0.35, 0.4, 0.5}, {0.3, 0.3, 0.3}, 40)
local floor = gr.material({0.65, 0.65, 0.6}, {0, 0, 0}, 1)

local scene = gr.node("scene")
scene:set_material(wood)

-- A stair of boxes
for i = 0, 5 do
  local step = gr.nh_box("step" .. i, {-2.5 + 0.6 * i, 0, -1.5}, {0.6, 0.35 * (i + 1), 1.6})
  if i % 2 == 1 then step:set_material(slate) end
  scene:add_child(step)
end

-- A cube standing on one corner: turn the diagonal upright.
local corner = gr.cube("corner")
corner:translate(-0.5, -0.5, -0.5):rotate("y", 45):rotate("x", 54.7356):translate(1.6, 0.87, 1.6)
corner:set_material(slate)
scene:add_child(corner)

local ground = gr.plane("ground")
ground:set_material(floor)
scene:add_child(ground)

gr.render(scene, "cube.png", 512, 512,
  {3.2, 3.4, 6.2}, {-0.43, -0.36, -0.82}, {0, 1, 0}, 40,
  {0.25, 0.25, 0.28},
  {gr.light({6, 9, 5}, {0.8, 0.78, 0.72}, {1, 0, 0}),
   gr.light({-5, 6, 6}, {0.22, 0.24, 0.3}, {1, 0, 0})},
  {background = {top = {0.3, 0.45, 0.7}, bottom = {0.8, 0.85, 0.9}}})
