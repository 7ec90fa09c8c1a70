-- A child may be moved after it was added, and given a child of its own.
local m = gr.material({0.4, 0.8, 0.8}, {0.2, 0.2, 0.2}, 10)
local root, arm, hand = gr.node('root'), gr.node('arm'), gr.sphere('hand')
root:add_child(arm)
arm:add_child(hand)
hand:set_material(m)
hand:scale(0.5, 1, 0.5)
hand:translate(0, -1, 0)
arm:rotate('z', 45)
root:translate(0, 0.5, -2)
hand:add_child(gr.sphere('ring'):scale(1.5, 0.1, 1.5))
gr.render(root, 'late.png', 64, 48, {0, 0, 6}, {0, 0, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})})
