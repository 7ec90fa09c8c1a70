-- Meshes: an OBJ file, and one made of tables (0-based faces of any number of corners).
local clay = gr.material({0.75, 0.45, 0.32}, {0.2, 0.2, 0.2}, 20)
local jade = gr.material({0.25, 0.6, 0.45}, {0.5, 0.5, 0.5}, 70)
local floor = gr.material({0.6, 0.6, 0.62}, {0, 0, 0}, 1)

local scene = gr.node("scene")

-- A vase whose vertex normals make it look smooth; made by scenes/meshes/make_vase.lua.
local vase = gr.mesh("vase", "meshes/vase.obj")
vase:set_material(clay)
vase:translate(-1.2, 0, 0)
scene:add_child(vase)

-- A dodecahedron: 20 vertices, 12 pentagons.
local p = (1 + math.sqrt(5)) / 2
local q = 1 / p
local vertices = {
  {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}, {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1},
  {0, p, q}, {0, p, -q}, {0, -p, q}, {0, -p, -q}, {q, 0, p}, {-q, 0, p}, {q, 0, -p}, {-q, 0, -p},
  {p, q, 0}, {p, -q, 0}, {-p, q, 0}, {-p, -q, 0},
}
local faces = {
  {0, 16, 1, 9, 8}, {0, 8, 4, 13, 12}, {0, 12, 2, 17, 16}, {1, 16, 17, 3, 14}, {1, 14, 15, 5, 9},
  {2, 12, 13, 6, 10}, {2, 10, 11, 3, 17}, {3, 11, 7, 15, 14}, {4, 8, 9, 5, 18}, {4, 18, 19, 6, 13},
  {5, 15, 7, 19, 18}, {6, 19, 7, 11, 10},
}
local gem = gr.mesh("gem", vertices, faces)
gem:set_material(jade)
gem:scale(0.62, 0.62, 0.62):rotate("x", 31.72):rotate("y", 20):translate(1.3, 0.86, 0.6)
scene:add_child(gem)

local ground = gr.plane("ground")
ground:set_material(floor)
scene:add_child(ground)

gr.render(scene, "mesh.png", 512, 512,
  {0, 2.8, 8}, {0, -0.2, -1}, {0, 1, 0}, 36,
  {0.25, 0.25, 0.28},
  {gr.light({5, 8, 6}, {0.8, 0.78, 0.74}, {1, 0, 0}),
   gr.light({-6, 5, 4}, {0.22, 0.24, 0.3}, {1, 0, 0})},
  {background = {top = {0.3, 0.4, 0.6}, bottom = {0.8, 0.83, 0.88}}})
