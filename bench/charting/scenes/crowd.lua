-- N instances of one small mesh, in a cloud that keeps its look whatever N is: crowd.lua -- N
local n = tonumber(arg[1])
local state = 1
local function random()  -- Park and Miller's generator: the same cloud everywhere
  state = state * 48271 % 2147483647
  return state / 2147483647
end
local half = 1 / n ^ (1 / 3)
local corners = {{half, 0, 0}, {-half, 0, 0}, {0, half, 0}, {0, -half, 0}, {0, 0, half}, {0, 0, -half}}
local grain = gr.mesh("grain", corners, {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}):set_material(gr.material {kd = {0.7, 0.5, 0.3}})
local root = gr.node("root")
for _ = 1, n do
  local place = gr.node("place"):translate(4 * random() - 2, 4 * random() - 2, 4 * random() - 2)
  place:add_child(grain)
  root:add_child(place)
end
gr.render {
  scene = root, file = "crowd.png", size = {320, 240}, ambient = 0.2, samples = 1,
  background = {0.2, 0.3, 0.5}, camera = {eye = {0, 1, 9}, look_at = {0, 0, 0}, fov = 34},
  lights = {gr.light {position = {5, 8, 9}, colour = 0.8}},
}
