-- One pin four times, each in a booth of its own, under a light whose radius grows from 0.
local white = gr.material({0.8, 0.78, 0.74}, {0, 0, 0}, 1)
local red = gr.material{kd = {0.75, 0.12, 0.1}, ks = {0.4, 0.4, 0.4}, shininess = 60}
local scene = gr.node("scene")
local function add(node, material)
  node:set_material(material)
  scene:add_child(node)
  return node
end
add(gr.plane("ground"), white)

local pin = gr.node("pin")
local stem = gr.cylinder("stem")
stem:set_material(gr.material({0.25, 0.25, 0.28}, {0.3, 0.3, 0.3}, 30))
stem:scale(0.07, 1, 0.07)
pin:add_child(stem)
local head = gr.nh_sphere("head", {0, 1.1, 0}, 0.28)
head:set_material(red)
pin:add_child(head)

local lights = {}
for i, radius in ipairs{0, 0.15, 0.35, 0.8} do
  local column, row = (i - 1) % 2, (i - 1) // 2
  local x, z = 4 * column - 2, 4 * row - 2
  local place = gr.node("place" .. i)
  place:add_child(pin)
  place:translate(x, 0, z)
  scene:add_child(place)
  lights[i] = gr.light{position = {x - 1.0, 2.7, z - 0.4}, colour = {0.95, 0.92, 0.85}, radius = radius}
end
-- Walls keep each light to its booth.
for _, box in ipairs{{{-4.1, 0, -0.1}, {8.2, 3.4, 0.2}}, {{-0.1, 0, -4.1}, {0.2, 3.4, 8.2}}, {{-4.1, 0, -4.1}, {8.2, 3.4, 0.2}},
                     {{-4.1, 0, -4.1}, {0.2, 3.4, 8.2}}, {{3.9, 0, -4.1}, {0.2, 3.4, 8.2}}, {{-4.1, 0, 3.9}, {8.2, 3.4, 0.2}}} do
  add(gr.nh_box("wall", box[1], box[2]), white)
end
gr.render{
  scene = scene, file = "soft_shadows.png", size = {512, 512},
  camera = {eye = {0, 17, 2.6}, look_at = {0, 0.3, 0.2}, up = {0, 1, 0}, fov = 33},
  ambient = {0.14, 0.15, 0.18},
  lights = lights,
  samples = 32,
}
