-- A sphere, and what a node's transforms make of it: stretched, flattened, mirrored.
local red = gr.material({0.85, 0.2, 0.15}, {0.5, 0.5, 0.5}, 60)
local blue = gr.material({0.2, 0.35, 0.85}, {0.5, 0.5, 0.5}, 60)
local floor = gr.material({0.6, 0.6, 0.6}, {0, 0, 0}, 1)

local scene = gr.node("scene")
scene:set_material(red)

local function ball(name)
  local node = gr.sphere(name)
  scene:add_child(node)
  return node
end

ball("round"):translate(0, 1, 0)
ball("stretched"):scale(0.45, 1.6, 0.45):translate(-2.1, 1.6, -0.4)
ball("flat"):set_material(blue):scale(1, 0.3, 0.7):rotate("z", 20):translate(2.1, 0.65, 0.3)

-- nh_sphere takes its centre and radius at once.
local small = gr.nh_sphere("small", {0.9, 0.35, 1.7}, 0.35)
small:set_material(blue)
scene:add_child(small)

local ground = gr.plane("ground")
ground:set_material(floor)
scene:add_child(ground)

gr.render(scene, "sphere.png", 512, 512,
  {0, 2.6, 9}, {0, -0.18, -1}, {0, 1, 0}, 42,
  {0.25, 0.25, 0.3},
  {gr.light({5, 8, 6}, {0.8, 0.8, 0.75}, {1, 0, 0}),
   gr.light({-6, 5, 3}, {0.2, 0.22, 0.3}, {1, 0, 0})},
  {background = {top = {0.25, 0.4, 0.7}, bottom = {0.75, 0.82, 0.9}}})
