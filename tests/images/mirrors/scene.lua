-- A mirror ball between two mirror walls, eight bounces deep.
local scene = gr.node("scene")
local mirror = gr.material{kd = {0.02, 0.02, 0.02}, ks = {0.4, 0.4, 0.4}, shininess = 100, reflectivity = {0.8, 0.85, 0.85}}
local ball = gr.nh_sphere("ball", {0, 1, 0}, 1)
ball:set_material(mirror)
scene:add_child(ball)
for side = -1, 1, 2 do
  local wall = gr.plane("wall", 6)
  wall:set_material(mirror)
  wall:rotate("z", 90 * side):translate(2 * side, 1, 0)
  scene:add_child(wall)
end
local cube = gr.nh_box("cube", {0.6, 0, 1.2}, 0.5)
cube:set_material(gr.material({0.8, 0.5, 0.1}, {0, 0, 0}, 1))
scene:add_child(cube)
local ground = gr.plane("ground")
ground:set_material(gr.material({0.6, 0.6, 0.55}, {0, 0, 0}, 1))
scene:add_child(ground)
gr.render(scene, "scene.png", 160, 120, {0, 2.2, 6}, {0, -0.25, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.25},
  {gr.light({4, 6, 5}, {0.7, 0.7, 0.65}, {1, 0, 0}), gr.light({-5, 4, 3}, {0.3, 0.3, 0.35}, {1, 0, 0})},
  {samples = 4, background = {top = {0.2, 0.35, 0.7}, bottom = {0.8, 0.85, 0.9}}})
