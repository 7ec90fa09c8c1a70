-- A mesh by its name alone: it lies in Assets/ beside the script.
local root = gr.node('root')
root:add_child(gr.mesh('crystal', 'crystal.obj'):set_material(gr.material({0.3, 0.7, 0.8}, {0.6, 0.6, 0.6}, 60)))
gr.render(root, 'assets.png', 64, 48, {2, 1, 5}, {-2, -1, -5}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {1, 1, 1}, {1, 0, 0})})
