-- The classic scheme, which loses the wire.
local scene = gr.node("scene")
scene:add_child(gr.plane("ground"):set_material(gr.material({0.6, 0.6, 0.55}, {0, 0, 0}, 1)))
scene:add_child(gr.nh_sphere("ball", {-0.8, 0.8, 0}, 0.8):set_material(gr.material({0.75, 0.3, 0.2}, {0.4, 0.4, 0.4}, 40)))
scene:add_child(gr.cylinder("wire"):scale(0.004, 3, 0.004):rotate("z", 25):translate(1.8, 0, 0.3)
  :set_material(gr.material({0.1, 0.1, 0.1}, {0, 0, 0}, 1)))
gr.render{scene = scene, file = "scene.png", size = {160, 120}, ambient = {0.2, 0.2, 0.25}, aa = "corners",
  camera = {eye = {0, 2.2, 6}, view = {0, -0.25, -1}, fov = 40},
  lights = {gr.light{position = {4, 6, 5}, colour = 0.5}, gr.light{position = {-4, 6, 5}, colour = 0.4, radius = 1}},
  background = {top = {0.2, 0.35, 0.7}, bottom = {0.8, 0.85, 0.9}}}
