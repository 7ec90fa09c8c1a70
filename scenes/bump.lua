-- The same height on four shapes, ever stronger: shading shows relief, outlines stay smooth.
-- In front a plate whose highlights are broken by fine noise, and one that is pierced.
local root = gr.node("root")
local clay = gr.material({0.62, 0.30, 0.19}, {0.25, 0.25, 0.25}, 40)
local octaves = {{scale = 5, weight = 1}, {scale = 10, weight = 0.5}, {scale = 20, weight = 0.25}}

for i, strength in ipairs{0, 0.05, 0.15, 0.4} do
  local ball = gr.sphere("ball" .. i):set_material(clay)
  ball:perlin_noise{on = "bump", kind = "turbulence", octaves = octaves, strength = strength}
  root:add_child(ball:translate(2.3 * i - 5.75, 1, 0))
end

-- Hammered metal: dents that a mirror shows best.
local metal = gr.material{kd = {0.10, 0.08, 0.04}, ks = {0.6, 0.5, 0.3}, shininess = 120, reflectivity = {0.75, 0.6, 0.35}}
root:add_child(gr.cylinder("drum"):set_material(metal)
  :perlin_noise{on = "bump", strength = 0.05, octaves = {{scale = 6, weight = 1}}, ramp = {{0, 0}, {0.5, 0.5}, {0.75, 0}}}
  :scale(0.9, 0.8, 0.9):translate(-2.3, 0, 2.8))
-- Water: a flat mirror that noise makes ripple.
local water = gr.material{kd = {0.01, 0.03, 0.04}, ks = 0.8, shininess = 200, reflectivity = 0.65}
root:add_child(gr.nh_box("pond", {-1, -0.05, -1}, {2, 0.3, 2}):set_material(water)
  :perlin_noise{on = "bump", strength = 0.03, octaves = {{scale = 3, weight = 1}, {scale = 7, weight = 0.4}}}:translate(0.4, 0, 2.8))
-- Rust: holes where the noise is low.
root:add_child(gr.blob("husk"):set_material(gr.material({0.3, 0.4, 0.45}, {0.3, 0.3, 0.3}, 20))
  :perlin_noise{on = "opacity", octaves = {{scale = 4, weight = 1}, {scale = 9, weight = 0.4}}, ramp = {{0.45, 0}, {0.46, 1}}}
  :scale(0.8, 0.8, 0.8):translate(2.9, 0.8, 2.6))

root:add_child(gr.plane("floor"):set_material(gr.material({1, 1, 1}, {0, 0, 0}, 1))
  :set_texture(gr.checker({0.55, 0.55, 0.52}, {0.36, 0.38, 0.40}, 1)))

gr.render{scene = root, file = "bump.png", size = {512, 512},
  camera = {eye = {0, 5, 12}, look_at = {0, 0.4, 0.9}, fov = 44}, ambient = 0.25,
  lights = {gr.light{position = {-7, 9, 8}, colour = {0.8, 0.78, 0.75}}},
  background = {top = {0.35, 0.5, 0.75}, bottom = {0.85, 0.88, 0.9}}}
