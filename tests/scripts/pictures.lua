-- Pictures by their file names, on nodes and below them.
local white = gr.material({1, 1, 1}, {0.1, 0.1, 0.1}, 10)
local root = gr.node('root')
local wall = gr.nh_box('wall', {-3, -1, -2}, {6, 4, 0.5})
wall:set_material(white)
wall:set_texture('brick.jpg')
root:add_child(wall)
local pair = gr.node('pair'):set_material(white):set_texture(gr.texture('marble.jpg', {2, 2}))
pair:add_child(gr.sphere('ball'):translate(-1.2, 0, 0))
pair:add_child(gr.cylinder('post'):translate(1.2, -1, 0))
root:add_child(pair)
gr.render(root, 'pictures.png', 64, 48, {0, 1, 7}, {0, -0.1, -1}, {0, 1, 0}, 45, {0.3, 0.3, 0.3},
          {gr.light({3, 5, 6}, {0.8, 0.8, 0.8}, {1, 0, 0})})
