-- What the cases of single shapes share: make() makes the shape's node, place(node) places one upright
-- at the left. To its right stands the same, mirrored and stretched unevenly; both on a ground.
return function(make, place)
  local scene = gr.node("scene"):set_material(gr.material({0.75, 0.3, 0.2}, {0.5, 0.5, 0.5}, 40))
  scene:add_child(place(make()):translate(-1.1, 0, 0))
  scene:add_child(make():scale(-0.5, 1.3, 0.8):rotate("z", 35):rotate("y", 40):translate(1.2, 0.9, 0.3)
    :set_material(gr.material({0.2, 0.4, 0.75}, {0.5, 0.5, 0.5}, 80)))
  scene:add_child(gr.plane("ground"):set_material(gr.material({0.6, 0.6, 0.55}, {0, 0, 0}, 1)))
  gr.render(scene, "scene.png", 160, 120, {0, 2.2, 6}, {0, -0.25, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.25},
    {gr.light({4, 6, 5}, {0.7, 0.7, 0.65}, {1, 0, 0}), gr.light({-5, 4, 3}, {0.3, 0.3, 0.35}, {1, 0, 0})},
    {samples = 4, background = {top = {0.2, 0.35, 0.7}, bottom = {0.8, 0.85, 0.9}}})
end
