-- The moon, from noise alone. Colour: dark seas and bright highlands. Relief: craters of four sizes,
-- each an octave of noise through a ramp of heights (floor, wall, rim, plain), and rough ground.
local root = gr.node("root")

local moon = gr.sphere("moon"):set_material(gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 1))
moon:perlin_noise{seed = 12, octaves = {{scale = 1.15, weight = 1}, {scale = 2.6, weight = 0.5},
    {scale = 6, weight = 0.25}, {scale = 14, weight = 0.2}, {scale = 33, weight = 0.16}},
  ramp = {{0.32, {0.17, 0.165, 0.16}}, {0.46, {0.26, 0.255, 0.25}}, {0.54, {0.54, 0.53, 0.51}}, {0.72, {0.78, 0.77, 0.74}}}}

local crater = {{0.16, 0.12}, {0.20, 0}, {0.27, 0.1}, {0.315, 1}, {0.34, 0.8}, {0.40, 0.6}}
for i, scale in ipairs{2.6, 6.1, 13.7, 29} do
  moon:perlin_noise{on = "bump", add = true, seed = 20 + i, strength = 0.17 / scale, octaves = {{scale = scale}}, ramp = crater}
end
moon:perlin_noise{on = "bump", add = true, seed = 5, strength = 0.035,
  octaves = {{scale = 5, weight = 1}, {scale = 12, weight = 0.5}, {scale = 28, weight = 0.25}, {scale = 65, weight = 0.14}}}
root:add_child(moon:rotate('x', 20):rotate('y', -35))

local sun = gr.light{position = {-40, 14, 30}, colour = {1.3, 1.27, 1.2}}
gr.render{scene = root, file = "moon.png", size = {512, 512},
  camera = {eye = {0, 0, 4.6}, look_at = {0, 0, 0}, fov = 28},
  ambient = {0.006, 0.007, 0.01}, lights = {sun}}
