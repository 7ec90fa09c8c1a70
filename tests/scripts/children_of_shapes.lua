-- Shapes as parents: what hangs below one follows its transform and takes its material.
local snow = gr.material({0.9, 0.9, 0.95}, {0.1, 0.1, 0.1}, 5)
local base = gr.sphere('base')
base:set_material(snow)
local middle = gr.sphere('middle'):scale(0.7, 0.7, 0.7):translate(0, 1.4, 0)
base:add_child(middle)
middle:add_child(gr.sphere('head'):scale(0.7, 0.7, 0.7):translate(0, 1.4, 0))
base:translate(0, -1, 0)
gr.render(base, 'snowman.png', 48, 64, {0, 0.5, 8}, {0, 0, -1}, {0, 1, 0}, 40, {0.3, 0.3, 0.3},
          {gr.light({5, 5, 5}, {0.7, 0.7, 0.7}, {1, 0, 0})})
