-- Places from a coroutine; errors caught and gone on from.
local function spiral(n)
  return coroutine.wrap(function()
    for i = 1, n do
      local a = 0.6 * i
      coroutine.yield(0.1 * i * math.cos(a), 0.1 * i * math.sin(a))
    end
  end)
end
local m = gr.material({0.9, 0.7, 0.2}, {0.3, 0.3, 0.3}, 20)
local root = gr.node('root'):set_material(m)
for x, y in spiral(30) do
  root:add_child(gr.nh_sphere('bead', {x, y, 0}, 0.2))
end
local ok, message = pcall(function() root:add_child(root) end)
assert(not ok and message:find('contain itself'))
local co = coroutine.create(function() error('lost') end)
assert(coroutine.resume(co) == false and coroutine.status(co) == 'dead')
gr.render(root, 'spiral.png', 64, 48, {0, 0, 9}, {0, 0, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})})
