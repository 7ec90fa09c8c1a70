-- S1 without its tori, for programs that have none.
return require "peer" {base = "S1.lua", name = "S1n", without = "torus"}
