-- One arc of pillars under six parents, as in Stonehenge.
local stone = gr.material({0.8, 0.7, 0.7}, {0.0, 0.0, 0.0}, 0)
local arc = gr.node('arc')
for side = -1, 1, 2 do
  arc:add_child(gr.cube('pillar'):set_material(stone):scale(0.8, 4, 0.8):translate(2 * side - 0.4, 0, 0))
end
arc:add_child(gr.cube('lintel'):set_material(stone):scale(5.6, 0.8, 1):translate(-2.8, 4, -0.1))
local scene = gr.node('scene')
scene:rotate('x', 23)
for i = 1, 6 do
  local place = gr.node('place' .. i)
  place:translate(0, 0, 10)
  place:rotate('y', (i - 1) * 60)
  place:add_child(arc)
  scene:add_child(place)
end
gr.render(scene, 'henge.png', 64, 64, {0, 2, 30}, {0, 0, -1}, {0, 1, 0}, 50, {0.4, 0.4, 0.4},
          {gr.light({200, 202, 430}, {0.8, 0.8, 0.8}, {1, 0, 0})})
