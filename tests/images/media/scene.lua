-- Nested, overlapping and touching media: a bubble in a ball in water; a ball half in the water; ice
-- against glass, sharing a face.
local scene = gr.node("scene")
local function add(node, material)
  node:set_material(material)
  scene:add_child(node)
  return node
end
local function clear(ior, absorption)
  return gr.material{kd = {0, 0, 0}, ks = {0.4, 0.4, 0.4}, shininess = 100, ior = ior, opacity = 0, absorption = absorption}
end
local glass = clear(1.5)
add(gr.nh_box("water", {-3, 0, -2}, {6, 1.6, 3}), clear(1.33, {0.5, 0.15, 0.1}))
add(gr.nh_sphere("ball", {-1.7, 0.8, 0}, 0.7), glass)
add(gr.nh_sphere("bubble", {-1.7, 0.8, 0}, 0.45), clear(1))
add(gr.nh_sphere("half", {0, 1.5, 0}, 0.6), glass)
add(gr.nh_box("ice", {1.1, 1.6, -0.6}, {0.6, 0.8, 0.9}), clear(1.31))
add(gr.nh_box("glass", {1.7, 1.6, -0.6}, {0.6, 0.8, 0.9}), glass)
add(gr.plane("ground"), gr.material({0.7, 0.65, 0.55}, {0, 0, 0}, 1))
add(gr.nh_box("wall", {-9, -0.5, -4}, {18, 9, 1}), gr.material({1, 1, 1}, {0, 0, 0}, 1))
  :set_texture(gr.checker({0.85, 0.8, 0.7}, {0.35, 0.3, 0.4}, 0.5))
gr.render(scene, "scene.png", 160, 120, {0.5, 2.6, 6.5}, {-0.07, -0.22, -1}, {0, 1, 0}, 42, {0.3, 0.3, 0.3},
  {gr.light({-3, 7, 6}, {0.7, 0.7, 0.7}, {1, 0, 0})}, {samples = 4, background = {0.7, 0.8, 0.9}})
