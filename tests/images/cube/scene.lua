-- A cube, its edges and corners.
local scene = gr.node("scene")
scene:set_material(gr.material({0.75, 0.3, 0.2}, {0.5, 0.5, 0.5}, 40))
local upright = gr.cube("box")
upright:rotate("y", 30):translate(-1.1, 0, 0)
scene:add_child(upright)
-- The same, mirrored and stretched unevenly.
local stretched = gr.cube("box")
stretched:scale(-0.5, 1.3, 0.8):rotate("z", 35):rotate("y", 40):translate(1.2, 0.9, 0.3)
stretched:set_material(gr.material({0.2, 0.4, 0.75}, {0.5, 0.5, 0.5}, 80))
scene:add_child(stretched)
local ground = gr.plane("ground")
ground:set_material(gr.material({0.6, 0.6, 0.55}, {0, 0, 0}, 1))
scene:add_child(ground)
gr.render(scene, "scene.png", 160, 120, {0, 2.2, 6}, {0, -0.25, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.25},
  {gr.light({4, 6, 5}, {0.7, 0.7, 0.65}, {1, 0, 0}), gr.light({-5, 4, 3}, {0.3, 0.3, 0.35}, {1, 0, 0})},
  {samples = 4, background = {top = {0.2, 0.35, 0.7}, bottom = {0.8, 0.85, 0.9}}})
