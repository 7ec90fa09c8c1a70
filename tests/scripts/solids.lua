-- The further primitives that authors added: cylinder, cone, torus, plane.
local floor = gr.material({0.5, 0.5, 0.5}, {0, 0, 0}, 1)
local red = gr.material({0.8, 0.2, 0.2}, {0.5, 0.5, 0.5}, 30)
local root = gr.node('root')
root:add_child(gr.plane('ground'):set_material(floor))
root:add_child(gr.cone('hat'):scale(1, 2, 1):translate(-2.5, 0, 0):set_material(red))
root:add_child(gr.cylinder('can'):set_material(red))
root:add_child(gr.torus('ring'):translate(2.8, 0.3, 0):set_material(red))
root:add_child(gr.blob('drop'):translate(0, 1, -3):set_material(red))
gr.render(root, 'solids.png', 64, 48, {0, 4, 9}, {0, -0.4, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {1, 1, 1}, {1, 0, 0})})
