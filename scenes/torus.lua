-- Tori: a linked chain, a thin hoop and a spindle torus (R < r).
local gold = gr.material{kd = {0.6, 0.42, 0.12}, ks = {0.7, 0.6, 0.4}, shininess = 80,
                         reflectivity = {0.2, 0.16, 0.08}}
local steel = gr.material{kd = {0.35, 0.37, 0.4}, ks = {0.7, 0.7, 0.7}, shininess = 120,
                          reflectivity = {0.25, 0.25, 0.27}}
local apple = gr.material({0.7, 0.12, 0.08}, {0.5, 0.5, 0.5}, 60)
local floor = gr.material({0.5, 0.52, 0.56}, {0, 0, 0}, 1)

local scene = gr.node("scene")
for i = 0, 5 do
  local link = gr.torus("link" .. i, 0.55, 0.14)
  link:set_material(i % 2 == 0 and gold or steel)
  link:rotate("x", 90 * (i % 2)):translate(-2 + 0.8 * i, 0.75, 0)
  scene:add_child(link)
end

local hoop = gr.torus("hoop", 1.6, 0.03)
hoop:set_material(steel)
hoop:rotate("x", 80):rotate("y", 25):translate(0.4, 1.62, -1.6)
scene:add_child(hoop)

local spindle = gr.torus("spindle", 0.3, 0.5)
spindle:set_material(apple)
spindle:translate(1.2, 0.5, 1.6)
scene:add_child(spindle)

local ground = gr.plane("ground")
ground:set_material(floor)
scene:add_child(ground)

gr.render(scene, "torus.png", 512, 512,
  {0, 3.4, 8.5}, {0, -0.28, -1}, {0, 1, 0}, 40,
  {0.25, 0.25, 0.28},
  {gr.light({5, 8, 5}, {0.8, 0.8, 0.76}, {1, 0, 0}),
   gr.light({-6, 4, 4}, {0.22, 0.24, 0.3}, {1, 0, 0})},
  {background = {top = {0.2, 0.3, 0.5}, bottom = {0.7, 0.75, 0.82}}})
