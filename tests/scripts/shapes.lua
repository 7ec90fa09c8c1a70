-- Not a scene: what requires.lua requires.
local shapes = {}
function shapes.dumbbell(name)
  local bell = gr.node(name)
  for side = -1, 1, 2 do
    bell:add_child(gr.sphere(name .. side):translate(1.5 * side, 0, 0))
  end
  bell:add_child(gr.cylinder(name .. ' bar'):translate(0, -0.5, 0):scale(0.3, 3, 0.3):rotate('z', 90))
  return bell
end
return shapes
