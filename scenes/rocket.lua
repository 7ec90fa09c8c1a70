-- Cones, and capsules: all that is near a straight line. A toy rocket takes off.
local white = gr.material{kd = {0.85, 0.84, 0.80}, ks = 0.5, shininess = 60, reflectivity = 0.05}
local red = gr.material{kd = {0.75, 0.08, 0.05}, ks = 0.5, shininess = 60, reflectivity = 0.05}
local steel = gr.material{kd = 0.08, reflectivity = {0.75, 0.78, 0.82}, glossiness = 0.15}
local night = gr.material{kd = {0.02, 0.05, 0.12}, ks = 0.8, shininess = 200, reflectivity = 0.1}
local flame = gr.material{kd = 0, emission = {1, 0.55, 0.1}}
local smoke = gr.material{kd = {0.8, 0.78, 0.76}}
local scene = gr.node("scene")

local rocket = gr.node("rocket")
rocket:add_child(gr.capsule("body", 2.2, 0.6):set_material(white))
rocket:add_child(gr.cone("nose"):set_material(red):scale(0.45, 1.1, 0.45):translate(0, 2.6, 0))
rocket:add_child(gr.torus("collar", 0.44, 0.06):set_material(steel):translate(0, 2.62, 0))
rocket:add_child(gr.cone("nozzle"):set_material(steel):scale(0.5, 0.9, 0.5):translate(0, -0.9, 0))
rocket:add_child(gr.cone("flame"):set_material(flame):scale(0.32, -1.1, 0.32):translate(0, -0.95, 0))
for i = 0, 2 do   -- each leg is a capsule that leans outward, with a foot
  local leg = gr.node("leg"):set_material(red)
  leg:add_child(gr.capsule("strut", 1.5, 0.11):rotate('z', -148):translate(0.5, 0.5, 0))
  leg:add_child(gr.capsule("foot", 0.25, 0.16):translate(1.3, -0.95, 0))
  rocket:add_child(leg:rotate('y', 120 * i + 15))
end
rocket:add_child(gr.sphere("porthole"):set_material(night):scale(0.3, 0.3, 0.12):translate(0, 1.7, 0.55))
rocket:add_child(gr.torus("ring", 0.3, 0.06):set_material(steel):rotate('x', 90):translate(0, 1.7, 0.56))
scene:add_child(rocket:rotate('z', -8):translate(0, 2.6, 0))

for i = 1, 22 do   -- clouds of smoke around the pad
  local turn, far = math.rad(i * 137.5), 0.35 + 0.13 * i
  scene:add_child(gr.nh_sphere("puff", {far * math.cos(turn), 0.2, far * math.sin(turn)}, 0.55 - 0.012 * i):set_material(smoke))
end
scene:add_child(gr.plane("ground"):set_material(gr.material{kd = {0.42, 0.36, 0.30}}))

gr.render{scene = scene, file = "rocket.png", size = {512, 512},
  camera = {eye = {0, 3.2, 12}, look_at = {0, 2.75, 0}, fov = 36}, ambient = {0.26, 0.27, 0.32},
  lights = {gr.light{position = {-6, 9, 8}, colour = {0.85, 0.82, 0.75}, radius = 1},
            gr.light{position = {0, 0.9, 0}, colour = {0.9, 0.5, 0.15}, falloff = {0.3, 0, 0.5}}},
  background = {top = {0.10, 0.20, 0.45}, bottom = {0.75, 0.70, 0.68}}}
