-- A mesh from tables.
local vertices = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {0, 1.6, 0}}
local faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}
dofile "pair_of.lua"(function() return gr.mesh("tetrahedron", vertices, faces) end,
                    function(node) return node:rotate("y", 20) end)
