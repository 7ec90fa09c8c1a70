-- A checkerboard to the horizon.
local floor = gr.plane("floor"):set_material(gr.material{kd = {1, 1, 1}, emission = 0})
floor:set_texture(gr.checker({1, 1, 1}, {0, 0, 0}, 1))
gr.render{scene = floor:translate(0, -0.37, 0), file = "checker.png", size = {320, 240}, ambient = 1,
          camera = {eye = {0, 1, 0}, look_at = {0.3, 0.8, -1}, fov = 50}, background = 0.5}
