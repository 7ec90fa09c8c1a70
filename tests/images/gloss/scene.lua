-- Glossy reflection, from a mirror to dull, and a frosted ball.
local scene = gr.node("scene")
local ground = gr.plane("ground")
ground:set_material(gr.material({0.8, 0.8, 0.8}, {0, 0, 0}, 1))
ground:set_texture(gr.checker({0.8, 0.75, 0.7}, {0.15, 0.2, 0.3}, 0.5))
ground:translate(0, -1e-3, 0)
scene:add_child(ground)
local function ball(i, material)
  local node = gr.nh_sphere("ball", {1.1 * (i - 1.5), 0.5, 0}, 0.5)
  node:set_material(material)
  scene:add_child(node)
end
for i, glossiness in ipairs{0, 0.1, 0.4} do
  ball(i - 1, gr.material{kd = {0, 0, 0}, ks = {0, 0, 0}, shininess = 1, reflectivity = {0.9, 0.8, 0.6}, glossiness = glossiness})
end
ball(3, gr.material{kd = {0, 0, 0}, ks = {0, 0, 0}, shininess = 1, ior = 1.5, opacity = 0, glossiness = 0.1})
gr.render(scene, "scene.png", 160, 120, {0, 1.4, 5}, {0, -0.18, -1}, {0, 1, 0}, 45, {0.3, 0.3, 0.3},
  {gr.light({3, 5, 4}, {0.8, 0.8, 0.75}, {1, 0, 0})},
  {samples = 16, background = {top = {0.2, 0.3, 0.6}, bottom = {0.9, 0.8, 0.7}}})
