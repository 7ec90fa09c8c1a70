-- Balls of growing glossiness mirror two glowing panels; "wrong": each glossiness is 7% larger, the
-- exponent 13% smaller.
local wrong = arg[1] == "wrong"
local scene = gr.node("scene")
local function panel(x, y, z, edge, colour)
  local node = gr.plane("panel", edge)
  node:set_material(gr.material{kd = {0, 0, 0}, ks = {0, 0, 0}, shininess = 1, emission = colour})
  node:translate(x, y, z)
  scene:add_child(node)
end
panel(-1, 2.5, 1, 1.5, {1, 0.8, 0.5})
panel(1.6, 2, 1.5, 1, {0.4, 0.7, 1})
for i, glossiness in ipairs{0.15, 0.35, 0.7} do
  local ball = gr.nh_sphere("ball", {1.1 * (i - 2), 0.5, 0}, 0.55)
  ball:set_material(gr.material{kd = {0, 0, 0}, ks = {0, 0, 0}, shininess = 1, reflectivity = {0.9, 0.9, 0.9},
                                glossiness = glossiness * (wrong and 1.07 or 1)})
  scene:add_child(ball)
end
gr.render(scene, "scene.exr", 72, 32, {0, 1.1, 4}, {0, -0.15, -1}, {0, 1, 0}, 22, {0, 0, 0}, {}, {samples = 256})
