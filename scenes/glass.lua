-- Balls of glass over a checker, eight levels deep: each shows the world upside down, and the others
-- in it.
local floor = gr.material{kd = {0.8, 0.8, 0.8}, ks = {0.1, 0.1, 0.1}, shininess = 30,
                          reflectivity = {0.06, 0.06, 0.06}}
local function glass(absorption)
  return gr.material{kd = {0, 0, 0}, ks = {0.6, 0.6, 0.6}, shininess = 300, ior = 1.5, opacity = 0,
                     absorption = absorption or {0.02, 0.01, 0.015}}
end
local red = gr.material{kd = {0.75, 0.1, 0.06}, ks = {0.5, 0.5, 0.5}, shininess = 80,
                        reflectivity = {0.04, 0.04, 0.04}}

local scene = gr.node("scene")
local ground = gr.plane("ground")
ground:set_material(floor)
ground:set_texture(gr.checker({0.82, 0.8, 0.75}, {0.1, 0.13, 0.2}, 1))
ground:translate(0, -1e-3, 0)  -- the checker's cells end at 0, just above
scene:add_child(ground)

local function ball(name, material, x, z, radius)
  local node = gr.nh_sphere(name, {x, radius, z}, radius)
  node:set_material(material)
  scene:add_child(node)
end
ball("large", glass(), 0, 0, 1.4)
ball("amber", glass{0.1, 0.45, 1.6}, -2.3, 0.9, 0.85)
ball("sea", glass{1.1, 0.22, 0.3}, 2.25, 0.9, 0.9)
ball("small", glass(), 0.95, 2.1, 0.45)
ball("tiny", glass{0.5, 1.2, 0.25}, -0.75, 2.3, 0.35)
ball("red", red, -1.5, -2.6, 1)
ball("far red", red, 2.6, -3.6, 0.8)

gr.render{
  scene = scene, file = "glass.png", size = {512, 512},
  camera = {eye = {0.8, 2.9, 9.2}, look_at = {0.05, 0.85, 0}, up = {0, 1, 0}, fov = 36},
  ambient = {0.18, 0.2, 0.24},
  lights = {gr.light{position = {-6, 9, 5}, colour = {0.95, 0.9, 0.8}}},
  background = {top = {0.18, 0.36, 0.68}, bottom = {0.93, 0.9, 0.86}},
  max_depth = 8,
}
