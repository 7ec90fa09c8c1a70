-- A light with a radius as its fourth argument, and one that dims.
local root = gr.node('root')
local grey = gr.material({0.7, 0.7, 0.7}, {0, 0, 0}, 1)
root:add_child(gr.plane('floor', 20):set_material(grey))
root:add_child(gr.nh_box('box', {-1, 0, -1}, 2):set_material(grey))
local lamp = gr.light({4, 6, 3}, {0.9, 0.8, 0.7}, {1, 0, 0}, 1.5)
local fill = gr.light({-6, 4, 6}, {0.4, 0.4, 0.6}, {1, 0.05, 0.001})
gr.render(root, 'soft.png', 64, 48, {0, 5, 10}, {0, -0.45, -1}, {0, 1, 0}, 40, {0.1, 0.1, 0.1}, {lamp, fill})
