-- A module in the manner of Lua 5.1.
-- warns: module is of Lua 5.1
local parts = require 'lib.parts51'
assert(count == nil, 'the module kept its globals to itself')
local root = gr.node('root')
root:set_material(gr.material({0.9, 0.5, 0.5}, {0.2, 0.2, 0.2}, 10))
root:add_child(parts.part('left'))
root:add_child(parts.part('right'))
assert(parts.count == 2)
gr.render(root, 'module51.png', 64, 48, {0, 0, 8}, {0, 0, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})})
