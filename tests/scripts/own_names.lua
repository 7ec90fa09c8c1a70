-- Beginners call their things table, math and string.
table = gr.cube('table')
math = gr.material({0.6, 0.4, 0.2}, {0.1, 0.1, 0.1}, 5)
string = gr.node('string')
type, pairs, print = 1, 2, 3
table:set_material(math):scale(3, 0.2, 2):translate(-1.5, 0, -1)
string:add_child(table)
next = gr.light({5, 8, 5}, {1, 1, 1}, {1, 0, 0})
gr.render(string, 'own.png', 64, 48, {0, 2, 6}, {0, -0.3, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2}, {next})
