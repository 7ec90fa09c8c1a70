-- A sphere and its shadow.
dofile "pair_of.lua"(function() return gr.sphere("ball") end,
                    function(node) return node:translate(0, 1, 0) end)
