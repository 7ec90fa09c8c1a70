-- Some authors' gr.render takes up to sixteen arguments: depth of field, threads, a sky.
-- warns: gr.render: ignored argument 11, a number (0.5); argument 12, a number (6); argument 13, a string ("sky.png"); argument 14, a boolean (true); argument 15, a table with 3 items; argument 16, a number (4)
local ball = gr.sphere('ball')
ball:set_material(gr.material({0.8, 0.5, 0.2}, {0.3, 0.3, 0.3}, 10))
local l = gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})
for frame = 1, 2 do
  gr.render(ball, 'sixteen' .. frame .. '.png', 64, 48, {0, 0, 4}, {0, 0, -1}, {0, 1, 0}, 45,
            {0.2, 0.2, 0.2}, {l}, 0.5, 6, 'sky.png', true, {1, 2, 3}, 4)
end
