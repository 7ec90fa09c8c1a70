-- A bounded plane, seen from both sides.
dofile "pair_of.lua"(function() return gr.plane("card", 1.5) end,
                    function(node) return node:rotate("x", 70):translate(0, 0.8, 0) end)
