-- A bubble of air in a ball of glass in a tank of water: at each surface the pair of media that meet
-- there bends the light, air to water, water to glass, glass to air.
local function clear(ior, absorption)
  return gr.material{kd = {0, 0, 0}, ks = {0.4, 0.4, 0.4}, shininess = 300, ior = ior, opacity = 0,
                     absorption = absorption}
end
local water = clear(1.33, {0.16, 0.045, 0.025})
local glass = clear(1.52, {0.01, 0.01, 0.01})
local air = clear(1.0)
local sand = gr.material({0.76, 0.68, 0.52}, {0, 0, 0}, 1)

local scene = gr.node("scene")
local function add(node, material)
  node:set_material(material)
  scene:add_child(node)
  return node
end
add(gr.nh_box("tank", {-4, 0, -3}, {8, 4, 6}), water)
add(gr.nh_sphere("ball", {0, 1.7, 0}, 1.3), glass)
add(gr.nh_sphere("bubble", {0, 1.7, 0}, 0.85), air)
for i, p in ipairs{{-2.3, 0.7, -0.6, 0.7}, {2.4, 0.55, 0.7, 0.55}, {1.6, 2.9, -1.3, 0.3}, {-1.7, 2.7, 0.6, 0.22}} do
  add(gr.nh_sphere("bead" .. i, {p[1], p[2], p[3]}, p[4]), i <= 2 and glass or air)
end
-- Seen through all of it: stripes on the wall behind, and the ground.
add(gr.plane("ground"), sand):set_texture(gr.checker({0.8, 0.72, 0.55}, {0.62, 0.5, 0.36}, 1))
local wall = add(gr.nh_box("wall", {-30, -1, -6}, {60, 40, 1}), sand)
wall:set_texture(gr.checker({0.9, 0.87, 0.8}, {0.7, 0.55, 0.5}, 0.999))

gr.render{
  scene = scene, file = "bubble.png", size = {512, 512},
  camera = {eye = {1.6, 3.0, 9.5}, look_at = {0, 1.85, 0}, up = {0, 1, 0}, fov = 36},
  ambient = {0.25, 0.26, 0.28},
  lights = {gr.light{position = {-4, 12, 8}, colour = {0.85, 0.82, 0.76}}},
  background = {top = {0.4, 0.55, 0.8}, bottom = {0.9, 0.92, 0.95}},
  max_depth = 8, samples = 8,
}
