-- Soft shadows and highlights of a spherical and a rectangular light, both in the picture.
local scene = gr.node("scene")
local function add(node, material)
  node:set_material(material)
  scene:add_child(node)
end
add(gr.plane("ground"), gr.material({0.75, 0.75, 0.7}, {0, 0, 0}, 1))
add(gr.nh_sphere("ball", {-0.8, 0.6, 0}, 0.6), gr.material({0.7, 0.15, 0.1}, {0.5, 0.5, 0.5}, 60))
add(gr.nh_box("box", {0.6, 0, -0.4}, {0.7, 1.2, 0.7}), gr.material({0.2, 0.35, 0.7}, {0.1, 0.1, 0.1}, 20))
gr.render(scene, "scene.png", 160, 120, {0, 2.2, 6.5}, {0, -0.16, -1}, {0, 1, 0}, 44, {0.15, 0.15, 0.17},
  {gr.light{position = {-2, 2.6, -0.5}, colour = {0.7, 0.65, 0.55}, radius = 0.35, visible = true},
   gr.light{position = {2.2, 2.8, -1}, colour = {0.45, 0.5, 0.6}, u = {0.9, 0, 0.3}, v = {0, 0.8, 0}, visible = true}},
  {samples = 16})
