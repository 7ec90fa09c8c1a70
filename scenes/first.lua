local root = gr.node("root")
local red = gr.material{kd = {0.75, 0.10, 0.08}, ks = 0.5, shininess = 60, reflectivity = 0.05}
local gold = gr.material{kd = {0.12, 0.08, 0.02}, reflectivity = {0.9, 0.65, 0.3}, glossiness = 0.15}
local glass = gr.material{kd = 0, ks = 0.5, shininess = 300, ior = 1.5, opacity = 0}
local stone = gr.material{kd = 1, reflectivity = 0.12}

root:add_child(gr.blob("gumdrop"):set_material(red):translate(-1.5, 1, 0))
root:add_child(gr.torus("ring", 1, 0.3):set_material(gold):rotate('x', 80):translate(0.9, 1.3, -0.9))
root:add_child(gr.sphere("ball"):set_material(glass):scale(0.7):translate(0.6, 0.7, 1.3))
root:add_child(gr.plane("floor"):set_material(stone):set_texture(gr.texture("marble.jpg", 0.2)))

gr.render{scene = root, file = "first.png", size = {640, 400},
  camera = {eye = {0.6, 2.6, 8}, look_at = {-0.1, 1, 0}, fov = 32}, ambient = 0.25,
  lights = {gr.light{position = {-4, 8, 5}, colour = {0.9, 0.85, 0.75}, radius = 1}},
  background = {top = {0.15, 0.25, 0.5}, bottom = {0.75, 0.72, 0.7}}}
