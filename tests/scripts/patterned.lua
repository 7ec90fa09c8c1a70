-- A checker as a texture; glass and mirrors by positional arguments.
local tiles = gr.checker({0.9, 0.9, 0.9}, {0.1, 0.1, 0.1}, 1)
local root = gr.node('root')
root:add_child(gr.plane('floor'):set_material(gr.material({1, 1, 1}, {0, 0, 0}, 1)):set_texture(tiles))
root:add_child(gr.nh_sphere('glass', {-1.2, 1, 0}, 1):set_material(gr.material({0.1, 0.1, 0.1}, {0.8, 0.8, 0.8}, 90, 1.5, 0.1)))
root:add_child(gr.nh_sphere('mirror', {1.2, 1, 0}, 1):set_material(gr.material{kd = 0.1, reflectivity = 0.8}))
gr.render(root, 'patterned.png', 64, 48, {0, 3, 8}, {0, -0.3, -1}, {0, 1, 0}, 40, {0.3, 0.3, 0.3},
          {gr.light({5, 8, 5}, {0.8, 0.8, 0.8}, {1, 0, 0})})
