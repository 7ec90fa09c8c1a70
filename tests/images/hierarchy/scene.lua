-- Joints within joints; one arm under two parents; a material handed down.
local scene = gr.node("scene")
scene:set_material(gr.material({0.3, 0.6, 0.35}, {0.3, 0.3, 0.3}, 20))
local function limb(depth)
  local joint = gr.joint("joint", {-90, 0, 90}, {-90, 0, 90})
  local bone = gr.cylinder("bone")
  bone:scale(0.12, 0.7, 0.12)
  joint:add_child(bone)
  if depth > 0 then
    local tip = limb(depth - 1)
    tip:scale(0.75, 0.75, 0.75)
    for side = -1, 1, 2 do
      local turn = gr.node("turn")
      turn:add_child(tip)
      turn:rotate("z", 35 * side):rotate("Y", 25):translate(0, 0.7, 0)
      joint:add_child(turn)
    end
  end
  return joint
end
scene:add_child(limb(4))
local ground = gr.plane("ground")
ground:set_material(gr.material({0.6, 0.6, 0.55}, {0, 0, 0}, 1))
scene:add_child(ground)
gr.render(scene, "scene.png", 160, 120, {0, 2.2, 6}, {0, -0.25, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.25},
  {gr.light({4, 6, 5}, {0.7, 0.7, 0.65}, {1, 0, 0}), gr.light({-5, 4, 3}, {0.3, 0.3, 0.35}, {1, 0, 0})},
  {samples = 4, background = {top = {0.2, 0.35, 0.7}, bottom = {0.8, 0.85, 0.9}}})
