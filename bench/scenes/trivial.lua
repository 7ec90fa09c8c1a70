-- One ball in few pixels: what it costs to start, to be subtracted from the other scenes' times.
return require "peer" {
  name = "trivial",
  size = {64, 48},
  camera = {eye = {0, 0, 5}, look_at = {0, 0, 0}, up = {0, 1, 0}, fov = 40},
  background = {0.1, 0.1, 0.1},
  trace_level = 1,
  lights = {
    {position = {5, 5, 5}, color = {0.9, 0.9, 0.9}},
  },
  materials = {
    a = {color = {0.8, 0.2, 0.2}, ambient = 0.1, diffuse = 0.8, phong = 0.4, phong_size = 40},
  },
  objects = {
    {"sphere", {0, 0, 0}, 1, "a"},
  },
}
