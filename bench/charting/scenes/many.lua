-- N balls and rings, each turned and placed by itself, in a cloud that keeps its look whatever N is:
-- many.lua -- N
local n = tonumber(arg[1])
local state = 1
local function random()  -- Park and Miller's generator: the same cloud everywhere
  state = state * 48271 % 2147483647
  return state / 2147483647
end
local edge = 4 / n ^ (1 / 3)
local root = gr.node("root")
for i = 1, n do
  local shape = i % 2 == 0 and gr.torus("ring") or gr.sphere("ball")
  shape:set_material(gr.material {kd = {random(), random(), random()}})
  shape:scale(0.25 * edge, 0.25 * edge, 0.25 * edge):rotate("x", 360 * random())
  root:add_child(shape:translate(4 * random() - 2, 4 * random() - 2, 4 * random() - 2))
end
gr.render {
  scene = root, file = "many.png", size = {320, 240}, ambient = 0.2, samples = 1,
  background = {0.2, 0.3, 0.5}, camera = {eye = {0, 1, 9}, look_at = {0, 0, 0}, fov = 34},
  lights = {gr.light {position = {5, 8, 9}, colour = 0.8}},
}
