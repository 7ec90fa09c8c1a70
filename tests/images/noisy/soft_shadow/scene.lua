-- Soft shadows of a spherical light; "wrong": its radius is 5% larger.
local wrong = arg[1] == "wrong"
local scene = gr.node("scene")
local function add(node, material)
  node:set_material(material)
  scene:add_child(node)
end
add(gr.plane("ground"), gr.material({0.8, 0.75, 0.7}, {0, 0, 0}, 1))
add(gr.nh_sphere("ball", {-0.7, 0.7, 0}, 0.5), gr.material({0.7, 0.2, 0.1}, {0, 0, 0}, 1))
add(gr.nh_box("box", {0.4, 0, -0.4}, {0.6, 1.1, 0.6}), gr.material({0.2, 0.4, 0.7}, {0, 0, 0}, 1))
gr.render(scene, "scene.exr", 64, 48, {0, 3, 5}, {0, -0.5, -1}, {0, 1, 0}, 40, {0.1, 0.1, 0.1},
  {gr.light{position = {-2, 4, 1}, colour = {0.8, 0.8, 0.8}, radius = wrong and 0.84 or 0.8}},
  {samples = 64})
