-- A checker to the horizon: what filtering of textures saves.
local root = gr.node("root")
root:add_child(gr.plane("plane"):set_material(gr.material(1, 0, 1)):set_texture(gr.checker(0.9, 0.1, 0.25)):rotate('y', 11))
gr.render{scene = root, file = "plane.exr", size = {320, 240}, ambient = 1, background = 0.5,
  camera = {eye = {0.3, 1.5, 0}, look_at = {0.3, 1.1, -2}, fov = 50}, max_samples = 65536}
