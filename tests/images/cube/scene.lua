-- A cube, its edges and corners.
dofile "pair_of.lua"(function() return gr.cube("box") end,
                    function(node) return node:rotate("y", 30) end)
