-- Blurred mirrors about balls, under a spherical light.
local root = gr.node("root")
root:add_child(gr.plane("floor"):set_material(gr.material{kd = 0.3, reflectivity = 0.5, glossiness = 0.3}))
local colours = {{0.8, 0.2, 0.1}, {0.2, 0.7, 0.2}, {0.2, 0.3, 0.8}}
for i, c in ipairs(colours) do
  root:add_child(gr.nh_sphere("ball", {2.4 * (i - 2), 1, 0}, 1):set_material(
    gr.material{kd = c, ks = 0.4, shininess = 50, reflectivity = 0.15 * i, glossiness = 0.2 * i}))
end
gr.render{scene = root, file = "glossy.png", size = {320, 240}, ambient = 0.1,
          background = {top = {0.3, 0.5, 0.9}, bottom = {0.9, 0.9, 0.9}},
          camera = {eye = {0, 3, 9}, look_at = {0, 0.8, 0}, fov = 36},
          lights = {gr.light{position = {4, 7, 5}, colour = 0.9, radius = 1}}}
