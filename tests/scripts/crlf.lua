#!/usr/bin/env raytracer
-- Saved by an editor of another system: a byte order mark, lines that end in CR LF.
local ball = gr.sphere("ball")
ball:set_material(gr.material({0.5, 0.5, 0.8}, {0.5, 0.5, 0.5}, 25))
gr.render(ball, "crlf.png", 64, 48, {0, 0, 4}, {0, 0, -1}, {0, 1, 0}, 45,
  {0.2, 0.2, 0.2}, {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})})
