-- Wires and beads of 0.02 to 2 pixels before a dark background, and their shadows on a floor.
local bright = gr.material{kd = {0.9, 0.9, 0.9}}
local root = gr.node("root")
root:add_child(gr.plane("floor"):set_material(gr.material{kd = {0.7, 0.7, 0.7}}))
for i = 0, 9 do
  local r = 0.0003 * 1.9 ^ i
  local wire = gr.cylinder("wire"):scale(r, 3, r):rotate("z", 12 + 9 * i):translate(2 - 0.3 * i, 0.3, -0.2 * i)
  root:add_child(wire:set_material(bright))
  root:add_child(gr.nh_sphere("bead", {-2 + 0.4 * i, 2.2, 1}, r):set_material(bright))
end
gr.render{scene = root, file = "wires.png", size = {320, 240}, ambient = 0.1,
          camera = {eye = {0, 2, 9}, look_at = {0, 1, 0}, fov = 32},
          lights = {gr.light{position = {3, 6, 4}, colour = 0.8}}}
