-- The course's encoding: values times 255, no sRGB.
local ball = gr.sphere("ball")
ball:set_material(gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 1))
gr.render(ball, "scene.png", 64, 64, {0, 0, 4}, {0, 0, -1}, {0, 1, 0}, 40, {0.1, 0.1, 0.1},
  {gr.light({3, 3, 6}, {1, 1, 1}, {1, 0, 0})}, {encoding = "raw", samples = 4})
