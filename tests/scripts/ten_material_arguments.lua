-- Some authors' gr.material takes up to ten: textures, bump maps, translucency by name.
-- warns: gr.material: ignored argument 5, a string ("wood.png"); argument 7, a boolean (true); argument 8, a table with 3 items; argument 9, a number (3); argument 10, a string ("x"). It takes
local odd = gr.material({0.5, 0.3, 0.2}, {0.4, 0.4, 0.4}, 20, 1.3, 'wood.png', 0.1, true, {0, 0, 1}, 3, 'x')
local plain = gr.material({0.3, 0.5, 0.7}, {0.4, 0.4, 0.4}, 20, 1.0, 1.0, 0, 'bump.png', nil, nil, 2)
local root = gr.node('root')
root:add_child(gr.sphere('a'):set_material(odd):translate(-1, 0, 0))
root:add_child(gr.sphere('b'):set_material(plain):translate(1, 0, 0))
gr.render(root, 'ten.png', 64, 48, {0, 0, 6}, {0, 0, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})})
