-- A corridor of columns between two mirrors, fifty reflections deep.
local stone = gr.material({0.72, 0.66, 0.56}, {0, 0, 0}, 1)
local mirror = gr.material{kd = {0.01, 0.015, 0.015}, ks = {0, 0, 0}, shininess = 1,
                           reflectivity = {0.9, 0.94, 0.92}}
local floor = gr.material{kd = {0.5, 0.5, 0.5}, ks = {0.2, 0.2, 0.2}, shininess = 60,
                          reflectivity = {0.15, 0.15, 0.15}}
local brass = gr.material{kd = {0.35, 0.22, 0.06}, ks = {0.8, 0.65, 0.35}, shininess = 60,
                          reflectivity = {0.45, 0.33, 0.15}}
local hall = gr.node("hall")
local function add(node, material)
  node:set_material(material)
  hall:add_child(node)
  return node
end
-- Mirrors stand at both ends; the side walls and the ceiling are stone.
add(gr.plane("floor", 20), floor):set_texture(gr.checker({0.75, 0.72, 0.68}, {0.12, 0.1, 0.1}, 0.6))
add(gr.nh_box("ceiling", {-2.2, 3.2, -4}, {4.4, 0.2, 8}), stone)
add(gr.nh_box("left", {-2.4, 0, -4}, {0.2, 3.2, 8}), stone)
add(gr.nh_box("right", {2.2, 0, -4}, {0.2, 3.2, 8}), stone)
add(gr.plane("far mirror", 8), mirror):rotate("x", 90):translate(0, 1, -3.2)
add(gr.plane("near mirror", 8), mirror):rotate("x", -90):translate(0, 1, 3.2)
for side = -1, 1, 2 do
  for k = -1, 1, 2 do
    local x, z = 1.75 * side, 1.6 * k
    add(gr.cylinder("shaft"), stone):scale(0.22, 2.7, 0.22):translate(x, 0.2, z)
    add(gr.nh_box("base", {x - 0.32, 0, z - 0.32}, {0.64, 0.2, 0.64}), brass)
    add(gr.torus("ring", 0.24, 0.07), brass):translate(x, 0.3, z)
    add(gr.nh_box("capital", {x - 0.32, 2.9, z - 0.32}, {0.64, 0.3, 0.64}), brass)
  end
end
add(gr.nh_sphere("ball", {0.5, 0.35, -1.3}, 0.35), brass)
gr.render{
  scene = hall, file = "mirror_corridor.png", size = {512, 512},
  camera = {eye = {-0.55, 1.7, 2.9}, look_at = {0.12, 1.45, -3}, up = {0, 1, 0}, fov = 58},
  ambient = {0.16, 0.15, 0.16},
  lights = {gr.light{position = {0, 3, 0}, colour = {1, 0.9, 0.72}, falloff = {0.7, 0.15, 0.06}}},
  max_depth = 50,
}
