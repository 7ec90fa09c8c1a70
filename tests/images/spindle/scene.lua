-- A spindle torus: R < r.
dofile "pair_of.lua"(function() return gr.torus("apple", 0.4, 0.6) end,
                    function(node) return node:translate(0, 0.6, 0) end)
