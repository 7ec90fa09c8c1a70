-- S5 without its torus.
return require "peer" {base = "S5.lua", name = "S5n", without = "torus"}
