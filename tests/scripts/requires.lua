-- A sibling file by require, in a folder by a dot, and by dofile.
local palette = require 'lib.palette'
local shapes = require('shapes')
assert(require('lib.palette') == palette)
local root = gr.node('root')
root:add_child(shapes.dumbbell('bell'):set_material(palette.gold))
root:add_child(dofile('lib/stand.lua'):set_material(palette.grey(0.5)))
gr.render(root, 'requires.png', 64, 48, {0, 1, 8}, {0, 0, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})})
