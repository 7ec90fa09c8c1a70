-- A scene that uses no feature that can be switched off: opaque, matt, still, under a point light.
local root = gr.node("root")
root:add_child(gr.plane("floor"):set_material(gr.material {kd = {0.5, 0.5, 0.45}}))
for i = -2, 2 do
  local ball = gr.nh_sphere("ball", {1.5 * i, 0.7, 0}, 0.7)
  root:add_child(ball:set_material(gr.material {kd = {0.7, 0.2 + 0.1 * i, 0.3}, ks = 0.3, shininess = 30}))
end
gr.render {
  scene = root, file = "plain.png", size = {320, 240}, ambient = 0.1, background = {0.2, 0.3, 0.5},
  camera = {eye = {0, 3, 9}, look_at = {0, 0.6, 0}, fov = 36},
  lights = {gr.light {position = {4, 7, 5}, colour = 0.9}},
}
