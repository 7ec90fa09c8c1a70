-- Random numbers, seeded and not; the time of day; many spheres.
math.randomseed(os.time and 42)
local colours = {}
for i = 1, 4 do
  colours[i] = gr.material({math.random(), math.random(), math.random()}, {0.3, 0.3, 0.3}, math.random(5, 40))
end
local root = gr.node('root')
for i = 1, 300 do
  local s = gr.sphere('s' .. i)
  s:scale(0.2, 0.2, 0.2)
  s:translate(6 * math.random() - 3, 4 * math.random() - 2, -6 * math.random())
  s:set_material(colours[i % 4 + 1])
  root:add_child(s)
end
gr.render(root, 'field.png', 64, 48, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 50, {0.2, 0.2, 0.2},
          {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})})
