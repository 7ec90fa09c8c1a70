-- A square of noise, of as many octaves as the argument says: what an octave costs.
local octaves = {}
for i = 1, tonumber(arg[1]) do
  octaves[i] = {scale = 1 + 0.37 * i}
end
local square = gr.plane("square"):set_material(gr.material(1, 0, 1)):rotate('x', 90)
square:perlin_noise{octaves = octaves}
gr.render{scene = square, file = "noise.exr", size = {512, 512}, ambient = 1,
  camera = {eye = {0, 0, 9}, look_at = {0, 0, 0}}}
