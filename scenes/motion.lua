-- What moves while the shutter is open is blurred along its path: a wheel that turns, a ball that
-- falls, one that is struck, and a pendulum.
local scene = gr.node("scene")
local function shiny(colour) return gr.material{kd = colour, ks = 0.4, shininess = 60} end

-- A wheel turns by 25 degrees about its hub; its stand does not.
local wheel = gr.node("wheel")
wheel:add_child(gr.torus("rim", 1.2, 0.1):set_material(shiny{0.15, 0.15, 0.18}):rotate('x', 90))
for i = 0, 5 do
  wheel:add_child(gr.cylinder("spoke"):set_material(shiny{0.80, 0.62, 0.25}):scale(0.06, 1.15, 0.06):rotate('z', 60 * i))
end
wheel:motion{to = {rotate = {'z', 25}}}
scene:add_child(gr.node("place"):translate(-1.35, 1.5, 0):add_child(wheel))
scene:add_child(gr.nh_box("stand", {-1.45, 0, -0.35}, {0.2, 1.6, 0.2}):set_material(shiny{0.5, 0.48, 0.45}))

-- A ball that falls: the path is a function of the time, 0 to 1.
local ball = gr.nh_sphere("falling", {0.5, 0, -1}, 0.35):set_material(shiny{0.80, 0.15, 0.12})
scene:add_child(ball:motion(function(t) return {translate = {0, 2.7 - 0.6 * t * t, 0}} end))

-- A ball that is struck: it leaves, and is flattened as it does.
local struck = gr.sphere("struck"):set_material(shiny{0.90, 0.60, 0.10}):scale(0.35):translate(0.2, 0.35, 1.4)
scene:add_child(struck:motion{from = {scale = {0.8, 1.1, 1.1}, about = {0.2, 0, 1.4}}, to = {translate = {0.45, 0, 0}}})

-- A pendulum.
local pendulum = gr.node("pendulum")
pendulum:add_child(gr.cylinder("string"):set_material(shiny{0.2, 0.2, 0.2}):translate(0, -1, 0):scale(0.05, 2, 0.05))
pendulum:add_child(gr.nh_sphere("bob", {0, -2, 0}, 0.32):set_material(shiny{0.06, 0.45, 0.50}))
pendulum:motion{from = {rotate = {'z', 8}}, to = {rotate = {'z', 19}}}
scene:add_child(gr.node("hook"):translate(1.3, 3.2, -0.2):add_child(pendulum))

scene:add_child(gr.plane("ground"):set_material(gr.material{kd = 1})
  :set_texture(gr.checker({0.72, 0.70, 0.66}, {0.58, 0.57, 0.56}, 0.5)):translate(0, -0.001, 0))
gr.render{scene = scene, file = "motion.png", size = {512, 512},
  camera = {eye = {0, 2.4, 9}, look_at = {0, 1.5, 0}, fov = 32}, ambient = {0.25, 0.25, 0.28},
  lights = {gr.light{position = {-4, 8, 6}, colour = {0.85, 0.82, 0.76}, radius = 0.6}},
  background = {top = {0.35, 0.5, 0.75}, bottom = {0.85, 0.88, 0.92}}}
