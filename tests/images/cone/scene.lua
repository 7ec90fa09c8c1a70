-- A cone, its apex and its disc.
dofile "pair_of.lua"(function() return gr.cone("hat") end,
                    function(node) return node:scale(0.9, 1.7, 0.9) end)
