-- Every kind of surface with the same picture of numbered squares: where u and v begin and end, and
-- what happens at seams and poles.
local root = gr.node("root")
local grid = gr.texture("grid.png")
-- Longitude grows clockwise as seen from above: round shapes show a picture mirrored, unless it is.
local turned = gr.texture("grid.png", {-1, 1})
local paper = gr.material({1, 1, 1}, {0.15, 0.15, 0.15}, 30)

local function show(node, column, row, texture)
  node:set_material(paper):set_texture(texture or turned)
  root:add_child(node:translate(2.6 * column, 0, 2.7 * row))
end

show(gr.sphere("sphere"):rotate('y', 100):translate(0, 1, 0), -1.5, -1)
show(gr.cylinder("cylinder"):rotate('y', 100):scale(0.8, 1.7, 0.8), -0.5, -1)
show(gr.cube("cube"):translate(-0.5, 0, -0.5):scale(1.5, 1.5, 1.5):rotate('y', 30), 0.5, -1, grid)
show(gr.cone("cone"):rotate('y', 100):scale(1, 1.9, 1), 1.5, -1)
show(gr.torus("torus", 0.85, 0.38):rotate('x', 38):translate(0, 0.85, 0), -1.5, 0.15)
show(gr.blob("blob"):rotate('y', 100):scale(0.85, 0.85, 0.85):translate(0, 0.85, 0), -0.5, 0.15)
show(gr.plane("plane", 1.9):rotate('x', 55):translate(0, 0.8, 0), 0.5, 0.15, grid)
show(gr.mesh("vase", "meshes/vase.obj"):rotate('y', 100):scale(0.9, 0.9, 0.9), 1.5, 0.15)

root:add_child(gr.plane("floor"):set_material(gr.material({0.42, 0.42, 0.45}, {0, 0, 0}, 1)))

gr.render{scene = root, file = "textures.png", size = {512, 512},
  camera = {eye = {0, 6.2, 9}, look_at = {0, 0.5, -0.6}, fov = 52}, ambient = 0.35,
  lights = {gr.light{position = {-5, 9, 8}, colour = {0.72, 0.7, 0.68}}},
  background = {top = {0.4, 0.5, 0.65}, bottom = {0.8, 0.8, 0.82}}}
