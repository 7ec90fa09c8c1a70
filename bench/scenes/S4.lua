-- Glass balls, eight levels deep, on a checkered floor.
return require "peer" {
  name = "S4",
  size = {640, 480},
  camera = {eye = {0, 2.6, 9}, look_at = {0, 0.9, 0}, up = {0, 1, 0}, fov = 34},
  background = {0.35, 0.5, 0.75},
  trace_level = 8,
  lights = {
    {position = {5, 9, 6}, color = {0.9, 0.9, 0.9}},
  },
  materials = {
    floor = {checker = {{0.85, 0.85, 0.85}, {0.15, 0.15, 0.2}, 1}, ambient = 0.1, diffuse = 0.8},
    glass = {glass = 1.5, phong = 0.5, phong_size = 200},
    red   = {color = {0.85, 0.15, 0.12}, ambient = 0.1, diffuse = 0.8, phong = 0.4, phong_size = 40},
  },
  objects = {
    {"plane", 0, "floor"},
    {"sphere", {0, 1.3, 0}, 1.3, "glass"},
    {"sphere", {-2.4, 1, 0.4}, 1, "glass"},
    {"sphere", {2.4, 1, 0.4}, 1, "glass"},
    {"sphere", {-1.1, 0.6, 2.3}, 0.6, "glass"},
    {"sphere", {1.1, 0.6, 2.3}, 0.6, "glass"},
    {"sphere", {-1.6, 0.9, -2.6}, 0.9, "glass"},
    {"sphere", {1.6, 0.9, -2.6}, 0.9, "glass"},
    {"sphere", {0, 0.45, 3.2}, 0.45, "red"},
    {"sphere", {0, 0.8, -4.5}, 0.8, "red"},
  },
}
