-- The named forms of everything, colours spelt both ways.
local scene = gr.node("scene")
scene:add_child(gr.sphere("ball"):set_material(gr.material{kd = {0.8, 0.3, 0.3}, ks = 0.4, shininess = 20}))
gr.render{
  scene = scene, file = "named.png", size = {64, 48},
  camera = {eye = {0, 1, 5}, look_at = {0, 0, 0}, up = {0, 1, 0}, fov = 40},
  ambient = 0.2, background = {top = {0.2, 0.3, 0.6}, bottom = 0.8},
  lights = {gr.light{position = {3, 5, 4}, color = {1, 1, 0.9}}, gr.light{position = {-3, 2, 4}, colour = 0.3}},
  max_depth = 4, seed = 3,
}
