-- A lens with an aperture: what stands at its focus is sharp, what is nearer or farther is blurred.
local scene = gr.node("scene")
local function shiny(colour) return gr.material{kd = colour, ks = 0.4, shininess = 80, reflectivity = 0.05} end

local colours = {{0.80, 0.15, 0.10}, {0.90, 0.55, 0.08}, {0.20, 0.55, 0.20}, {0.08, 0.45, 0.55}, {0.40, 0.22, 0.60}}
for i = 1, 15 do
  local pawn = gr.node("pawn"):set_material(shiny(colours[i % 5 + 1]))
  pawn:add_child(gr.cone("skirt"):scale(0.5, 1.3, 0.5))
  pawn:add_child(gr.torus("collar", 0.17, 0.07):translate(0, 0.82, 0))
  pawn:add_child(gr.nh_sphere("head", {0, 1.15, 0}, 0.28))
  scene:add_child(pawn:translate(0.8 * (i - 8) + 0.35 * (i % 2), 0, -1.6 * (i - 6)))
end
scene:add_child(gr.plane("board"):set_material(gr.material{kd = 1, reflectivity = 0.08})
  :set_texture(gr.checker({0.75, 0.70, 0.60}, {0.20, 0.16, 0.14}, 1)):translate(0, -0.001, 0))

local eye, sharp = {-3.4, 2.4, 12}, {-1.6, 0.7, 0}         -- the sixth pawn is sharp
local d = {sharp[1] - eye[1], sharp[2] - eye[2], sharp[3] - eye[3]}
local distance = math.sqrt(d[1] ^ 2 + d[2] ^ 2 + d[3] ^ 2)
gr.render{scene = scene, file = "lens.png", size = {512, 512},
  camera = {eye = eye, look_at = sharp, fov = 30, aperture = 0.6, focus = distance},
  ambient = {0.2, 0.2, 0.24}, lights = {gr.light{position = {-6, 9, 6}, colour = {0.9, 0.87, 0.8}, radius = 1}},
  background = {top = {0.25, 0.35, 0.6}, bottom = {0.8, 0.8, 0.85}}}
