-- Calls of things that only one author's program has.
-- options: --lenient
-- warns: there is no gr.heightmap
-- warns: there is no gr.skybox
-- warns: nodes have no method 'set_bump'
-- warns: gr.material: unknown key 'translucency'
-- warns: unknown key 'supersampling'
local root = gr.node('root')
root:add_child(gr.heightmap('hills', 'hills.png', 64):translate(0, -1, 0):scale(3, 1, 3))
gr.skybox('stars.png')
local ball = gr.sphere('ball'):set_bump('bumps.png'):scale(1, 1, 1)
ball:set_material(gr.material{kd = {0.2, 0.7, 0.7}, translucency = 0.5})
root:add_child(ball)
gr.render(root, 'lenient.png', 64, 48, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})}, {supersampling = 4})
