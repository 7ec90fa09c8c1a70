-- gr.plane(name) has no end; gr.plane(name, size) is a square of that edge.
local ground_paint = gr.material({0.45, 0.5, 0.35}, {0, 0, 0}, 1)
local card_paint = gr.material({0.8, 0.55, 0.2}, {0.3, 0.3, 0.3}, 25)
local mirror = gr.material{kd = {0.02, 0.02, 0.03}, ks = {0.5, 0.5, 0.5}, shininess = 200,
                           reflectivity = {0.8, 0.85, 0.85}}

local scene = gr.node("scene")
local ground = gr.plane("ground")
ground:set_material(ground_paint)
scene:add_child(ground)

local pond = gr.plane("pond", 3)
pond:set_material(mirror)
pond:translate(0, 0.01, 1.5)
scene:add_child(pond)

for i = -2, 2 do
  local card = gr.plane("card" .. i, 1.2)
  card:set_material(card_paint)
  card:rotate("x", 90):rotate("y", 20 * i):translate(1.4 * i, 0.65, -1 - 0.2 * i * i)
  scene:add_child(card)
end

gr.render(scene, "plane.png", 512, 512,
  {0, 2.2, 7}, {0, -0.25, -1}, {0, 1, 0}, 45,
  {0.25, 0.25, 0.28},
  {gr.light({3, 6, 5}, {0.9, 0.87, 0.8}, {1, 0, 0})},
  {background = {top = {0.25, 0.4, 0.75}, bottom = {0.85, 0.88, 0.92}}})
