-- Balls of glass on a checker: refraction, Fresnel reflection, absorption, eight levels deep.
local scene = gr.node("scene")
local ground = gr.plane("ground")
ground:set_material(gr.material({0.8, 0.8, 0.8}, {0, 0, 0}, 1))
ground:set_texture(gr.checker({0.8, 0.8, 0.75}, {0.15, 0.15, 0.25}, 1))
ground:translate(0, -1e-3, 0)
scene:add_child(ground)
local function ball(x, z, radius, material)
  local node = gr.nh_sphere("ball", {x, radius, z}, radius)
  node:set_material(material)
  scene:add_child(node)
end
local function glass(opacity, absorption)
  return gr.material{kd = {0.8, 0.2, 0.2}, ks = {0.5, 0.5, 0.5}, shininess = 200, ior = 1.5, opacity = opacity, absorption = absorption}
end
ball(0, 0, 1, glass(0, {0, 0, 0}))
ball(-1.9, 0.3, 0.8, glass(0, {0.2, 0.5, 1.5}))
ball(1.8, 0.5, 0.7, glass(0.4, {0, 0, 0}))
gr.render(scene, "scene.png", 160, 120, {0.4, 1.8, 5.5}, {-0.05, -0.2, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.22},
  {gr.light({4, 6, 5}, {0.8, 0.8, 0.75}, {1, 0, 0})},
  {samples = 4, background = {top = {0.2, 0.35, 0.7}, bottom = {0.8, 0.85, 0.9}}})
