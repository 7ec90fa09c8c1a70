-- The same metal, from a mirror (glossiness 0, left) to brushed and dull (1, right).
local scene = gr.node("scene")
local ground = gr.plane("ground")
ground:set_material(gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 1))
ground:set_texture(gr.checker({0.75, 0.72, 0.66}, {0.16, 0.15, 0.17}, 0.5))
ground:translate(0, -1e-3, 0)
scene:add_child(ground)
for i, glossiness in ipairs{0, 0.1, 0.25, 0.5, 1} do
  local ball = gr.nh_sphere("ball" .. i, {1.12 * (i - 3), 0.5, 0}, 0.5)
  ball:set_material(gr.material{kd = {0.03, 0.02, 0.01}, ks = {0, 0, 0}, shininess = 1,
                                reflectivity = {0.95, 0.78, 0.5}, glossiness = glossiness})
  scene:add_child(ball)
end
-- Things to be mirrored: coloured posts behind and, out of the picture, before the balls.
local colours = {{0.8, 0.1, 0.08}, {0.1, 0.45, 0.75}, {0.15, 0.6, 0.25}, {0.85, 0.6, 0.1}}
for i = 0, 23 do
  local post = gr.cylinder("post" .. i)
  post:set_material(gr.material(colours[i % 4 + 1], {0.2, 0.2, 0.2}, 20))
  local behind = i < 12
  post:scale(0.12, behind and 1.5 or 1.2, 0.12)
  post:translate(0.9 * (i % 12 - 5.5), 0, behind and -1.5 or 7)
  scene:add_child(post)
end
gr.render{
  scene = scene, file = "gloss.png", size = {512, 512},
  camera = {eye = {0, 1.05, 5.4}, look_at = {0, 0.72, 0}, up = {0, 1, 0}, fov = 54},
  ambient = {0.2, 0.2, 0.22},
  lights = {gr.light{position = {3, 7, 4}, colour = {0.9, 0.86, 0.8}, radius = 1.5}},
  background = {top = {0.15, 0.25, 0.5}, bottom = {0.85, 0.75, 0.7}},
  samples = 48,
}
