-- Written for the older frameworks: what is said last is done first.
-- options: --transform-order post
local m = gr.material({0.6, 0.6, 0.2}, {0.2, 0.2, 0.2}, 10)
local root = gr.node('root')
root:rotate('x', 20)
for i = 0, 5 do
  local arm = gr.cube('arm' .. i)
  arm:set_material(m)
  arm:rotate('y', 60 * i)
  arm:translate(1, 0, -0.2)
  arm:scale(1.5, 0.4, 0.4)
  root:add_child(arm)
end
gr.render(root, 'post.png', 64, 64, {0, 0, 8}, {0, 0, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 5, 5}, {1, 1, 1}, {1, 0, 0})})
