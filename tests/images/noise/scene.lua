-- The four kinds, near and far: octaves that a sample cannot carry fade.
local root = gr.node("root")
for i, kind in ipairs{"fbm", "turbulence", "marble", "wood"} do
  local octaves = {{scale = 3, weight = 1}, {scale = 6, weight = 0.5}, {scale = 12, weight = 0.25}}
  for row = 0, 1 do
    root:add_child(gr.sphere(kind):set_material(gr.material(1, 0.2, 30)):translate(2.2 * i - 5.5, 1, -14 * row)
      :perlin_noise{kind = kind, seed = i, octaves = octaves,
        ramp = {{0, {0.1, 0.1, 0.3}}, {0.5, {0.8, 0.5, 0.2}}, {1, {1, 1, 0.9}}}})
  end
end
root:add_child(gr.plane("ground"):set_material(gr.material(1, 0, 1))
  :perlin_noise{octaves = {{scale = 1, weight = 1}, {scale = 4, weight = 0.7}}, low = {0.1, 0.2, 0.05}, high = {0.6, 0.7, 0.4}})
gr.render{scene = root, file = "scene.png", size = {160, 90},
  camera = {eye = {0, 2.6, 8}, look_at = {0, 1.2, 0}, fov = 40}, ambient = 0.3,
  lights = {gr.light{position = {-5, 8, 7}, colour = 0.7}}, samples = 4}
