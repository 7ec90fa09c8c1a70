-- Depth of field: a row of balls, the middle one in focus.
local root = gr.node("root")
root:add_child(gr.plane("floor"):set_material(gr.material{kd = {0.6, 0.6, 0.55}}))
for i = -3, 3 do
  root:add_child(gr.nh_sphere("ball", {0.9 * i, 0.5, -2 * i}, 0.5):set_material(
    gr.material{kd = {0.5 + 0.12 * i, 0.4, 0.5 - 0.12 * i}, ks = 0.5, shininess = 60}))
end
gr.render{scene = root, file = "scene.png", size = {160, 120}, samples = 32, ambient = 0.15,
          background = {top = {0.3, 0.5, 0.9}, bottom = {0.9, 0.9, 0.9}},
          camera = {eye = {0, 2, 9}, look_at = {0, 0.5, 0}, fov = 36, aperture = 0.5, focus = 9.1},
          lights = {gr.light{position = {4, 7, 5}, colour = 0.9}}}
