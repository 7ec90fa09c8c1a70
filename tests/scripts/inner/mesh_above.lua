-- Meshes in the folder above the script's, and in Assets/ there.
local stone = gr.material({0.6, 0.55, 0.5}, {0.1, 0.1, 0.1}, 5)
local root = gr.node('root')
root:add_child(gr.mesh('wedge', 'wedge.obj'):set_material(stone))
root:add_child(gr.mesh('crystal', 'crystal.obj'):set_material(stone):translate(2.5, 0, 0))
gr.render(root, 'above.png', 64, 48, {3, 3, 7}, {-2, -3, -7}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {1, 1, 1}, {1, 0, 0})})
