-- S5 under a spherical light.
return require "peer" {
  base = "S5.lua",
  name = "S5s",
  lights = {
    {position = {3, 7, 3}, color = {0.9, 0.9, 0.9}, radius = 1},
  },
}
