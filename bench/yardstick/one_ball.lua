-- One ball under one point of light, and nothing else.
local ball = gr.nh_sphere("ball", {0.1, -0.05, 0}, 1)
ball:set_material(gr.material {kd = {0.8, 0.3, 0.2}, ks = 0.4, shininess = 40})
gr.render {
  scene = ball, file = "one_ball.png", size = {1024, 768}, samples = 1, ambient = 0.1,
  background = {0.1, 0.15, 0.3}, camera = {eye = {0.3, 0.5, 4}, look_at = {0, 0, 0}, fov = 34},
  lights = {gr.light {position = {3, 4, 5}, colour = 0.9}},
}
