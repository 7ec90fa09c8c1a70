-- The camera stands inside a cube, which is a room: surfaces are lit on the side that is seen.
local room = gr.nh_box("room", {-3, 0, -4}, {6, 3, 8})
room:set_material(gr.material({0.7, 0.65, 0.55}, {0, 0, 0}, 1))
local lamp = gr.nh_sphere("table", {0.8, 0.6, -2}, 0.6)
lamp:set_material(gr.material({0.2, 0.3, 0.6}, {0.5, 0.5, 0.5}, 40))
room:add_child(lamp)
gr.render{scene = room, file = "scene.png", size = {160, 120},
  camera = {eye = {0, 1.5, 3.5}, look_at = {0, 1.2, -2}, fov = 60}, ambient = {0.1, 0.1, 0.1},
  lights = {gr.light{position = {-1, 2.8, 0}, colour = {1.2, 1.1, 1}, falloff = {1, 0.1, 0.05}}}, samples = 4}
