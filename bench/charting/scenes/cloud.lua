-- What clouds of things share: numbers that are the same everywhere, places, and how one looks at it:
-- by one sample a pixel, or, where the script's second argument is "adaptive", as many as it needs.
local state = 1
local cloud = {}

function cloud.random()  -- Park and Miller's generator
  state = state * 48271 % 2147483647
  return state / 2147483647
end

--- Moves a node to somewhere in the cube from -2 to 2.
function cloud.place(node)
  return node:translate(4 * cloud.random() - 2, 4 * cloud.random() - 2, 4 * cloud.random() - 2)
end

function cloud.render(root, file)
  gr.render {
    scene = root, file = file, size = {320, 240}, ambient = 0.2,
    samples = arg[2] ~= "adaptive" and 1 or nil,
    background = {0.2, 0.3, 0.5}, camera = {eye = {0, 1, 9}, look_at = {0, 0, 0}, fov = 34},
    lights = {gr.light {position = {5, 8, 9}, colour = 0.8}},
  }
end

return cloud
