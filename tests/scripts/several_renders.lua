-- A film: the graph changes between pictures.
local ball = gr.sphere('ball')
ball:set_material(gr.material({0.2, 0.6, 0.3}, {0.5, 0.5, 0.5}, 20))
local root = gr.node('root')
root:add_child(ball)
local l = gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})
for i = 0, 3 do
  gr.render(root, string.format('film%02d.png', i), 32, 24, {0, 0, 6}, {0, 0, -1}, {0, 1, 0}, 45,
            {0.2, 0.2, 0.2}, {l})
  ball:translate(0.3, 0, 0)
  root:rotate('z', 15)
end
