-- A blob, smooth at its join, closed below.
dofile "pair_of.lua"(function() return gr.blob("gumdrop") end,
                    function(node) return node:scale(0.8, 0.8, 0.8):translate(0, 0.8, 0) end)
