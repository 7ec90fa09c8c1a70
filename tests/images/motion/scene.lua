-- A ball that crosses, a wheel that turns on its axle while it rolls, a ball thrown up; a light that moves.
local scene = gr.node("scene")
local function matt(r, g, b) return gr.material({r, g, b}, {0.4, 0.4, 0.4}, 40) end
scene:add_child(gr.plane("ground"):set_material(gr.material({0.6, 0.6, 0.55}, {0, 0, 0}, 1)))
scene:add_child(gr.nh_sphere("ball", {-2.2, 0.5, 0.5}, 0.5):set_material(matt(0.75, 0.3, 0.2))
  :motion{to = {translate = {1, 0, 0}}})
local wheel = gr.node("wheel"):set_material(matt(0.2, 0.4, 0.75))
for i = 0, 2 do
  wheel:add_child(gr.nh_box("spoke", {0, -0.08, -0.08}, {0.9, 0.16, 0.16}):rotate("z", 120 * i))
end
wheel:motion{to = {rotate = {"z", -40}}}
scene:add_child(gr.node("axle"):add_child(wheel):translate(0, 1, 0):motion{to = {translate = {0.6, 0, 0}}})
scene:add_child(gr.nh_sphere("thrown", {2, 0.4, 0.5}, 0.4):set_material(matt(0.3, 0.6, 0.3))
  :motion(function(t) return {translate = {0, 4 * t * (1 - t), 0}} end))
gr.render{scene = scene, file = "scene.png", size = {160, 120}, ambient = {0.2, 0.2, 0.25}, samples = 32,
  camera = {eye = {0, 2.2, 6}, view = {0, -0.25, -1}, fov = 40}, shutter = {0, 0.9},
  lights = {gr.light{position = {4, 6, 5}, to = {3.5, 6, 5}, colour = {0.9, 0.9, 0.85}}},
  background = {top = {0.2, 0.35, 0.7}, bottom = {0.8, 0.85, 0.9}}}
