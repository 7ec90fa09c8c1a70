-- Marble and wood are noise in space: a solid is cut out of them, so that veins and rings run
-- through its edges.
local root = gr.node("root")

local polished = gr.material{kd = {1, 1, 1}, ks = {0.35, 0.35, 0.35}, shininess = 60, reflectivity = 0.06}
local varnish = gr.material{kd = {1, 1, 1}, ks = {0.2, 0.18, 0.15}, shininess = 30}

local function marble(node, seed)
  return node:set_material(polished):perlin_noise{kind = "marble", seed = seed,
    octaves = {{scale = 1.3, weight = 1}, {scale = 2.7, weight = 0.5}, {scale = 5.5, weight = 0.25}, {scale = 11, weight = 0.12},
               {scale = 22, weight = 0.06}},
    ramp = {{0, {0.12, 0.13, 0.16}}, {0.12, {0.42, 0.42, 0.44}}, {0.4, {0.78, 0.77, 0.74}}, {1, {0.93, 0.92, 0.88}}}}
end

local function wood(node, seed, size)
  return node:set_material(varnish):perlin_noise{kind = "wood", seed = seed,
    octaves = {{scale = 5 * size, weight = 1}, {scale = 1.1 * size, weight = 2.2}, {scale = 40 * size, weight = 0.25}},
    ramp = {{0, {0.22, 0.095, 0.035}}, {0.25, {0.36, 0.17, 0.065}}, {0.8, {0.55, 0.30, 0.13}}, {1, {0.62, 0.36, 0.17}}}}
end

-- A table top of wood, sawn lengthwise from beside the trunk's core.
local top = wood(gr.nh_box("table", {-3.6, -5, 1.3}, {8, 10, 0.3}), 3, 0.8)
root:add_child(top:rotate('x', -90):translate(0, -1.6, 0))

root:add_child(marble(gr.sphere("ball"), 0):translate(-1.3, 1, 0.2))
root:add_child(marble(gr.torus("ring", 0.72, 0.28), 5):translate(0.9, 0.28, 1.7))
root:add_child(wood(gr.blob("bell"), 9, 1.6):scale(0.8, 0.8, 0.8):rotate('z', 6):translate(1.5, 0.8, -0.9))
root:add_child(wood(gr.nh_box("block", {-0.5, 0, -0.5}, {1, 0.6, 1}), 2, 2):rotate('x', 90):rotate('y', 25):translate(-0.9, 0.5, 2.5))

local lamp = gr.light{position = {-4, 8, 6}, colour = {0.85, 0.83, 0.8}, radius = 1}
gr.render{scene = root, file = "marble_wood.png", size = {512, 512},
  camera = {eye = {0, 4.2, 8.5}, look_at = {0.1, 0.5, 0.5}, fov = 34},
  ambient = 0.28, lights = {lamp}, background = {top = {0.5, 0.55, 0.62}, bottom = {0.75, 0.75, 0.75}}}
