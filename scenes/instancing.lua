-- Instancing: a tree is built once and stands in the wood many times.
local bark = gr.material({0.35, 0.24, 0.16}, {0, 0, 0}, 1)
local leaf = gr.material({0.2, 0.45, 0.18}, {0.1, 0.1, 0.1}, 10)
local meadow = gr.material({0.45, 0.55, 0.3}, {0, 0, 0}, 1)

local tree = gr.node("tree")
local trunk = gr.cylinder("trunk")
trunk:set_material(bark)
trunk:scale(0.12, 0.8, 0.12)
tree:add_child(trunk)
for i = 0, 3 do
  local tier = gr.blob("tier" .. i)
  tier:set_material(leaf)
  local size = 0.62 - 0.13 * i
  tier:scale(size, 0.6 * size, size):translate(0, 0.85 + 0.5 * i, 0)
  tree:add_child(tier)
end

-- The same node under many parents: none of it is copied.
local wood = gr.node("wood")
math.randomseed(3)
for row = 0, 19 do
  for column = 0, 19 do
    local place = gr.node("place")
    place:add_child(tree)
    local size = 0.8 + 0.5 * math.random()
    place:scale(size, size, size):rotate("y", 360 * math.random())
    place:translate(2 * (column - 9.5) + math.random() - 0.5, 0, -2 * row + math.random())
    wood:add_child(place)
  end
end

local ground = gr.plane("ground")
ground:set_material(meadow)
wood:add_child(ground)

gr.render(wood, "instancing.png", 512, 512,
  {0, 6, 10}, {0, -0.35, -1}, {0, 1, 0}, 45,
  {0.3, 0.32, 0.36},
  {gr.light({60, 90, 40}, {0.75, 0.72, 0.62}, {1, 0, 0})},
  {background = {top = {0.3, 0.5, 0.8}, bottom = {0.85, 0.9, 0.95}}})
