-- Recursion: a tree whose twigs share their parts.
local bark = gr.material({0.45, 0.3, 0.2}, {0, 0, 0}, 1)
local function branch(depth)
  local node = gr.node('branch' .. depth)
  node:add_child(gr.cylinder('wood'):scale(0.1, 1, 0.1):set_material(bark))
  if depth > 0 then
    local twig = branch(depth - 1)
    for i = 0, 2 do
      local at = gr.node('fork')
      at:add_child(twig)
      at:scale(0.7):rotate('z', 35):rotate('y', 120 * i + 20 * depth):translate(0, 1, 0)
      node:add_child(at)
    end
  end
  return node
end
gr.render(branch(5), 'tree.png', 64, 64, {0, 1.5, 5}, {0, 0, -1}, {0, 1, 0}, 45, {0.3, 0.3, 0.3},
          {gr.light({5, 5, 5}, {0.7, 0.7, 0.7}, {1, 0, 0})})
