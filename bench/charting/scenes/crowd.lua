-- N instances of one small mesh, in a cloud that keeps its look whatever N is: crowd.lua -- N
local cloud = require "cloud"
local n = tonumber(arg[1])
local half = 1 / n ^ (1 / 3)
local corners = {{half, 0, 0}, {-half, 0, 0}, {0, half, 0}, {0, -half, 0}, {0, 0, half}, {0, 0, -half}}
local grain = gr.mesh("grain", corners, {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}):set_material(gr.material {kd = {0.7, 0.5, 0.3}})
local root = gr.node("root")
for _ = 1, n do
  local place = cloud.place(gr.node("place"))
  place:add_child(grain)
  root:add_child(place)
end
cloud.render(root, "crowd.png")
