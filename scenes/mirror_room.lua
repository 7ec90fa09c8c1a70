-- A room whose two side walls are mirrors: the row of balls goes on without end, as far as
-- max_depth lets it.
local wall = gr.material({0.7, 0.66, 0.58}, {0, 0, 0}, 1)
local tiles = gr.material{kd = {0.3, 0.32, 0.36}, ks = {0.3, 0.3, 0.3}, shininess = 60,
                          reflectivity = {0.12, 0.12, 0.12}}
local mirror = gr.material{kd = {0.02, 0.02, 0.02}, ks = {0, 0, 0}, shininess = 1,
                           reflectivity = {0.86, 0.88, 0.88}}
local red = gr.material{kd = {0.7, 0.12, 0.1}, ks = {0.5, 0.5, 0.5}, shininess = 60}
local chrome = gr.material{kd = {0.05, 0.05, 0.05}, ks = {0.6, 0.6, 0.6}, shininess = 200,
                           reflectivity = {0.8, 0.8, 0.8}}

local room = gr.node("room")
local function square(name, material)
  local node = gr.plane(name, 6)
  node:set_material(material)
  room:add_child(node)
  return node
end
square("floor", tiles)
square("ceiling", wall):rotate("x", 180):translate(0, 4, 0)
square("back", wall):rotate("x", 90):translate(0, 1, -3)
square("front", wall):rotate("x", -90):translate(0, 1, 3)
square("left", mirror):rotate("z", -90):translate(-2.5, 1, 0)
square("right", mirror):rotate("z", 90):translate(2.5, 1, 0)

local function ball(name, material, x, y, z, radius)
  local node = gr.nh_sphere(name, {x, y, z}, radius)
  node:set_material(material)
  room:add_child(node)
end
ball("red", red, -1, 0.6, -0.8, 0.6)
ball("chrome", chrome, 0.9, 0.8, -1.4, 0.8)
ball("small", red, 0.5, 0.25, 0.2, 0.25)

gr.render{
  scene = room, file = "mirror_room.png", size = {512, 512},
  camera = {eye = {2.1, 1.9, 2.2}, look_at = {-1.6, 0.9, -1}, up = {0, 1, 0}, fov = 62},
  ambient = {0.22, 0.22, 0.24},
  lights = {gr.light{position = {0, 3.7, 0}, colour = {1.1, 1.05, 0.95}, falloff = {0.6, 0.1, 0.02}}},
  max_depth = 24,
}
