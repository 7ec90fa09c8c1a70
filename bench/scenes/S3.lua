-- The sphereflake: 7381 balls that mirror each other once.
return require "peer" {
  name = "S3",
  size = {640, 480},
  camera = {eye = {1.6, 1.5, 2.1}, look_at = {0, 0.05, 0}, up = {0, 1, 0}, fov = 36},
  background = {0.08, 0.36, 0.57},
  trace_level = 2,
  lights = {
    {position = {4, 4, 2}, color = {0.5, 0.5, 0.5}},
    {position = {-3, 5, 4}, color = {0.3, 0.3, 0.3}},
  },
  materials = {
    floor = {color = {0.8, 0.6, 0.35}, ambient = 0.1, diffuse = 0.8},
    ball  = {color = {0.6, 0.5, 0.35}, ambient = 0.1, diffuse = 0.6, phong = 0.4, phong_size = 30, reflect = 0.4},
  },
  objects = {
    {"plane", -0.5, "floor"},
    -- centre, radius, levels, material
    {"sphereflake", {0, 0, 0}, 0.5, 4, "ball"},
  },
}
