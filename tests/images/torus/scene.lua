-- A ring that shadows itself.
dofile "pair_of.lua"(function() return gr.torus("ring", 0.8, 0.3) end,
                    function(node) return node:rotate("x", 60):translate(0, 1, 0) end)
