local palette = {}
palette.gold = gr.material({0.8, 0.6, 0.2}, {0.8, 0.7, 0.4}, 50)
palette.never_used = gr.material({1, 0, 1}, {0, 0, 0}, 1)
function palette.grey(level) return gr.material({level, level, level}, {0, 0, 0}, 1) end
return palette
