-- A cylinder and its caps.
dofile "pair_of.lua"(function() return gr.cylinder("drum") end,
                    function(node) return node:scale(0.8, 1.5, 0.8) end)
