-- Narrow and wide penumbrae under two lights, a sphere and a rectangle, one inside a mirror.
local root = gr.node("root")
root:add_child(gr.plane("floor"):set_material(gr.material{kd = {0.7, 0.7, 0.65}}))
for i = 0, 4 do
  root:add_child(gr.nh_box("post", {1.2 * i - 3, 0, 0.4 * i - 1}, {0.2, 0.4 + 0.6 * i, 0.2}):set_material(
    gr.material{kd = {0.7, 0.3, 0.1 * i}}))
end
root:add_child(gr.nh_sphere("mirror", {1, 1, -3}, 1.2):set_material(gr.material{kd = 0.05, reflectivity = 0.85}))
gr.render{scene = root, file = "penumbra.png", size = {320, 240}, ambient = 0.1,
          camera = {eye = {0, 4, 8}, look_at = {0, 0.6, 0}, fov = 42}, background = {0.2, 0.3, 0.5},
          lights = {gr.light{position = {5, 6, 3}, colour = 0.6, radius = 0.3},
                    gr.light{position = {-4, 6, 4}, colour = 0.5, u = {2, 0, 0}, v = {0, 0, 2}}}}
