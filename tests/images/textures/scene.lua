-- The grid of numbered squares on every kind of surface, and a filtered checker to the horizon.
local root = gr.node("root")
local grid = gr.texture("grid.png")
local function show(node, x, z)
  root:add_child(node:set_material(gr.material(1, 0, 1)):set_texture(grid):translate(x, 0, z))
end
show(gr.sphere("sphere"):translate(0, 1, 0), -3.4, 0)
show(gr.cylinder("cylinder"):scale(0.8, 1.6, 0.8), -1.2, 0)
show(gr.cube("cube"):rotate('y', 30), 0.5, 0)
show(gr.torus("torus", 0.7, 0.3):rotate('x', 60):translate(0, 0.9, 0), 3.2, 0)
show(gr.blob("blob"):scale(0.7, 0.7, 0.7):translate(0, 0.7, 0), -2.2, 2)
show(gr.plane("square", 1.4):rotate('x', 60):translate(0, 0.7, 0), 0, 2.2)
show(gr.cone("cone"):scale(0.8, 1.5, 0.8), 2, 2)
root:add_child(gr.plane("floor"):set_material(gr.material(1, 0, 1)):set_texture(gr.checker(0.7, 0.2, 0.5)))
gr.render{scene = root, file = "scene.png", size = {160, 100},
  camera = {eye = {0, 2.4, 7.5}, look_at = {0, 0.8, 0}, fov = 45}, ambient = 0.3,
  lights = {gr.light{position = {-5, 8, 7}, colour = 0.7}}, samples = 4}
