-- What Lua 5.1 had. Each warns once.
-- warns: unpack is of Lua 5.1
-- warns: table.getn is of Lua 5.1
-- warns: string.gfind is of Lua 5.1
-- warns: math.pow is of Lua 5.1
-- warns: loadstring is of Lua 5.1
-- warns: table.foreach is of Lua 5.1
-- warns: math.mod is of Lua 5.1
local root = gr.node('root')
local list = {{-1, 0, 0}, {1, 0, 0}, {0, 1.5, 0}}
local m = gr.material({0.5, 0.5, 0.9}, {0.2, 0.2, 0.2}, math.pow(2, 4))
for i = 1, table.getn(list) do
  root:add_child(gr.sphere('s' .. i):translate(unpack(list[i])):set_material(m))
  assert(math.pow(i, 2) == i * i and math.mod(i, 2) == i % 2)
end
for word in string.gfind('two words', '%a+') do assert(#word > 2) end
assert(loadstring('return 1 + 1')() == 2 and not loadstring('x = ='))
local sum = 0
table.foreach({1, 2, 3}, function(_, v) sum = sum + v end)
assert(sum == 6)
gr.render(root, 'lua51.png', 64, 48, {0, 0, 8}, {0, 0, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})})
