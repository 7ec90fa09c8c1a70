-- Relief by noise and by a picture, on a mirror, and holes by noise with their shadow.
local root = gr.node("root")
local clay = gr.material(0.6, 0.3, 40)
root:add_child(gr.sphere("noise"):set_material(clay):translate(-2.3, 1, 0)
  :perlin_noise{on = "bump", strength = 0.12, octaves = {{scale = 4, weight = 1}, {scale = 9, weight = 0.5}}})
root:add_child(gr.cube("picture"):set_material(clay):rotate('y', 30):scale(1.4, 1.4, 1.4):translate(-0.6, 0, 0)
  :set_texture("brick.jpg", "bump", 0.05))
root:add_child(gr.sphere("mirror"):set_material(gr.material{kd = 0.05, reflectivity = 0.8}):translate(2.4, 1, 0)
  :perlin_noise{on = "bump", strength = 0.05, octaves = {{scale = 3}}})
root:add_child(gr.plane("veil", 1.6):set_material(gr.material({0.7, 0.3, 0.2}, 0, 1)):rotate('x', 70):translate(0.4, 0.8, 2.4)
  :perlin_noise{on = "opacity", octaves = {{scale = 3}}, ramp = {{0.5, 0}, {0.52, 1}}})
root:add_child(gr.plane("floor"):set_material(gr.material(1, 0, 1)):set_texture(gr.checker(0.6, 0.3, 1)))
gr.render{scene = root, file = "scene.png", size = {160, 100},
  camera = {eye = {0, 2.8, 7.5}, look_at = {0, 0.8, 0.4}, fov = 42}, ambient = 0.2,
  lights = {gr.light{position = {-5, 7, 7}, colour = 0.8}}, background = {top = {0.3, 0.5, 0.8}, bottom = 0.8}, samples = 4}
