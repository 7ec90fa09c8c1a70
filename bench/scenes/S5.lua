-- A rectangular light and its soft shadows.
return require "peer" {
  name = "S5",
  size = {640, 480},
  camera = {eye = {0, 4.2, 9}, look_at = {0, 0.6, 0}, up = {0, 1, 0}, fov = 32},
  background = {0.2, 0.3, 0.5},
  trace_level = 1,
  lights = {
    {position = {3, 7, 3}, color = {0.9, 0.9, 0.9}, u = {2, 0, 0}, v = {0, 0, 2}},
  },
  materials = {
    floor = {color = {0.7, 0.7, 0.65}, ambient = 0.1, diffuse = 0.8},
    red   = {color = {0.85, 0.15, 0.12}, ambient = 0.1, diffuse = 0.8, phong = 0.4, phong_size = 40},
    blue  = {color = {0.15, 0.25, 0.85}, ambient = 0.1, diffuse = 0.8, phong = 0.4, phong_size = 40},
    green = {color = {0.15, 0.7, 0.2}, ambient = 0.1, diffuse = 0.8, phong = 0.4, phong_size = 40},
    gold  = {color = {0.85, 0.65, 0.15}, ambient = 0.1, diffuse = 0.8, phong = 0.4, phong_size = 40},
  },
  objects = {
    {"plane", 0, "floor"},
    {"sphere", {-1.8, 1, 0}, 1, "red"},
    {"box", {1.7, 0.75, -0.6}, {0.75, 0.75, 0.75}, 25, "blue"},
    {"cylinder", {0.2, 0, 1.4}, {0.2, 1.3, 1.4}, 0.35, "green"},
    {"torus", {-0.2, 0.9, -2.2}, {0, 0.2873478855663454, 0.9578262852211513}, 0.75, 0.2, "gold"},
  },
}
