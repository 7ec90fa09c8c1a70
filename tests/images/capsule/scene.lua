-- A capsule, smooth where its parts join.
dofile "pair_of.lua"(function() return gr.capsule("pill", 0.8, 0.5) end,
                    function(node) return node:translate(0, 0.5, 0) end)
