-- A party in the nursery: Pip, in a swimming ring, jumps past the moon, and Bo looks on.

-- Units are about a foot; x is to the right, y up, z towards the camera. The floor is y = 0.

local room = gr.node("room")
local function add(node) room:add_child(node); return node end

-- Materials ----------------------------------------------------------------------------------

local function matt(colour) return gr.material{kd = colour} end
local function shiny(colour)   -- like a sweet, or fresh paint
  return gr.material{kd = colour, ks = 0.5, shininess = 60, reflectivity = 0.04}
end
local function metal(colour, glossiness)   -- glossiness 0 is a mirror, 1 is dull
  local r, g, b = table.unpack(colour)
  return gr.material{kd = {0.15 * r, 0.15 * g, 0.15 * b}, reflectivity = colour, glossiness = glossiness}
end

local white, black = shiny{0.9, 0.9, 0.88}, shiny{0.015, 0.013, 0.02}
local pink, red = shiny{0.85, 0.30, 0.36}, shiny{0.70, 0.06, 0.05}
local yellow = shiny{0.90, 0.55, 0.06}
local glint = gr.material{kd = 0, emission = 1}
local brass, silver = metal({0.88, 0.62, 0.28}, 0.12), metal({0.9, 0.92, 0.94}, 0)
local glass = gr.material{kd = 0, ks = 0.5, shininess = 400, ior = 1.5, opacity = 0, absorption = {0.05, 0.015, 0.02}}
local plaster = matt{0.36, 0.33, 0.46}   -- lavender: brick and skin are warm
local timber = gr.material{kd = {0.55, 0.5, 0.42}, ks = 0.15, shininess = 30}

-- The room -----------------------------------------------------------------------------------

-- A wall of bricks from a corner, with edges of that size. One picture of bricks measures 3 x 3;
-- walls whose edges are multiples of half that join without a cut.
local function bricks(corner, size)
  local across = math.max(size[1], size[3])
  local scale = {across / 3, size[2] / 3}
  return add(gr.nh_box("bricks", corner, size):set_material(matt(1))
    :set_texture(gr.texture("brick.jpg", scale)):set_texture(gr.texture("brick.jpg", scale), "bump", 0.03))
end

-- The wall at the back leaves an opening of 4.5 x 3 for the window, from (0, 1.5) to (4.5, 4.5).
bricks({-7.5, 0.0, -4.4}, {7.5, 7.5, 0.4})
bricks({ 4.5, 0.0, -4.4}, {3.0, 7.5, 0.4})
bricks({ 0.0, 0.0, -4.4}, {4.5, 1.5, 0.4})
bricks({ 0.0, 4.5, -4.4}, {4.5, 3.0, 0.4})
add(gr.nh_box("left wall", {-6.4, 0, -4.4}, {0.4, 7.5, 18}):set_material(plaster))
add(gr.nh_box("right wall", {6.0, 0, -4.4}, {0.4, 7.5, 18}):set_material(plaster))
add(gr.nh_box("wall behind us", {-6.4, 0, 13.2}, {12.8, 7.5, 0.4}):set_material(plaster))
add(gr.nh_box("ceiling", {-6.4, 7.5, -4.4}, {12.8, 0.4, 18}):set_material(plaster))

add(gr.plane("floor", 40)
  :set_material(gr.material{kd = 1, ks = 0.2, shininess = 120, reflectivity = 0.14})
  :set_texture(gr.texture("marble.jpg", {8, 8})))

-- The window's frame, its bar and its sill; the skirting board.
for _, bar in ipairs{{-0.12, 1.38, 4.74, 0.24}, {-0.12, 4.38, 4.74, 0.24}, {-0.12, 1.38, 0.24, 3.24}, {4.38, 1.38, 0.24, 3.24},
                     {2.17, 1.5, 0.16, 3}, {-6, 0, 12, 0.35}} do
  local x, y, width, height = table.unpack(bar)
  add(gr.nh_box("bar", {x, y, -4.2}, {width, height, 0.3}):set_material(timber))
end
add(gr.nh_box("sill", {-0.3, 1.3, -4}, {5.1, 0.12, 0.45}):set_material(timber))

local function ball(name, centre, radius, material)
  return gr.nh_sphere(name, centre, radius):set_material(material)
end

-- Bunting: flags hang from a line that sags between two hooks.
local flag_colours = {matt{0.85, 0.75, 0.55}, matt{0.05, 0.42, 0.42}, matt{0.80, 0.16, 0.10}, matt{0.90, 0.58, 0.10}}
local flag = {{-0.32, 0, 0}, {0.32, 0, 0}, {0, -0.62, 0}}
local function bunting(x0, x1, y, sag, flags)
  local function line(t) return x0 + (x1 - x0) * t, y - sag * 4 * t * (1 - t) end
  for i = 1, flags do
    local x, height = line((i - 0.5) / flags)
    local left_x, left_y = line((i - 1) / flags)
    local right_x, right_y = line(i / flags)
    local slope = math.deg(math.atan(right_y - left_y, right_x - left_x))
    local length = math.sqrt((right_x - left_x) ^ 2 + (right_y - left_y) ^ 2)
    add(gr.mesh("flag", flag, {{0, 1, 2}}):set_material(flag_colours[i % 4 + 1]):rotate('z', slope):translate(x, height, -3.8))
    add(gr.cylinder("line"):set_material(timber):translate(0, -0.5, 0):scale(0.015, length, 0.015)
      :rotate('z', slope - 90):translate(x, height, -3.8))
  end
  add(ball("hook", {x1, y, -3.8}, 0.07, brass))
end
bunting(-6, -0.4, 5.5, 0.7, 7)
bunting(-0.4, 6, 5.5, 0.45, 8)

-- Things in the room -------------------------------------------------------------------------

-- A sphere that is stretched: arms, feet, cheeks.
local function egg(name, size, material)
  return gr.sphere(name):set_material(material):scale(size)
end

add(ball("glass ball", {2.55, 0.72, 2.7}, 0.72, glass))

-- A bell is a blob of brass with a rim and a handle.
local bell = gr.node("bell"):set_material(brass)
bell:add_child(gr.blob("body"))
bell:add_child(gr.torus("rim", 1.22, 0.1):translate(0, -1, 0))
bell:add_child(gr.cylinder("handle"):scale(0.13, 0.6, 0.13):translate(0, 0.9, 0))
bell:add_child(gr.nh_sphere("knob", {0, 1.6, 0}, 0.28))
add(bell:translate(0, 1.1, 0):scale(0.5):translate(4.7, 0, 0.2))

-- A mirror stands against the wall.
local mirror = gr.node("mirror")
mirror:add_child(gr.nh_box("glass", {-1, 0.1, 0}, {2, 3.6, 0.05}):set_material(silver))
for _, side in ipairs{{-1.15, 0, 2.3, 0.16}, {-1.15, 3.64, 2.3, 0.16}, {-1.15, 0, 0.16, 3.8}, {0.99, 0, 0.16, 3.8}} do
  local x, y, width, height = table.unpack(side)
  mirror:add_child(gr.nh_box("frame", {x, y, -0.05}, {width, height, 0.2}):set_material(brass))
end
add(mirror:rotate('x', -6):rotate('y', 38):translate(-4.4, 0, -2.6))

-- A doughnut with icing and sprinkles, on a plate.
local doughnut = gr.node("doughnut")
doughnut:add_child(gr.cylinder("plate"):set_material(white):scale(1.25, 0.06, 1.25))
doughnut:add_child(gr.torus("dough", 0.62, 0.34):set_material(matt{0.62, 0.36, 0.14}):scale(1, 0.9, 1):translate(0, 0.36, 0))
doughnut:add_child(gr.torus("icing", 0.62, 0.335):set_material(pink):scale(1, 0.9, 1):translate(0, 0.41, 0))
local sprinkle_colours = {shiny{0.9, 0.9, 0.85}, shiny{0.1, 0.5, 0.6}, shiny{0.95, 0.7, 0.1}, shiny{0.4, 0.65, 0.2}}
for i = 1, 60 do
  local around, across = i * 137.5, 20 + (i * 47) % 140     -- degrees: about the axis, over the tube
  doughnut:add_child(gr.capsule("sprinkle", 0.09, 0.024):set_material(sprinkle_colours[i % 4 + 1])
    :translate(0, -0.045, 0):rotate('x', 90):rotate('y', i * 73)
    :translate(0, 0.345, 0):rotate('z', across - 90):translate(0.62, 0, 0):rotate('y', around)
    :scale(1, 0.9, 1):translate(0, 0.41, 0))
end
add(doughnut:scale(0.74):translate(-0.12, 0, 2.25))

-- A present, with a ribbon.
local present = gr.node("present")
present:add_child(gr.nh_box("box", {-0.5, 0, -0.5}, {1, 0.8, 1}):set_material(shiny{0.16, 0.42, 0.12}))
present:add_child(gr.nh_box("ribbon", {-0.51, 0, -0.1}, {1.02, 0.81, 0.2}):set_material(yellow))
present:add_child(gr.nh_box("ribbon", {-0.1, 0, -0.51}, {0.2, 0.815, 1.02}):set_material(yellow))
for side = -1, 1, 2 do
  present:add_child(gr.torus("bow", 0.16, 0.06):set_material(yellow):rotate('x', 90):scale(1.3, 1, 1)
    :rotate('z', 25 * side):translate(0.2 * side, 0.93, 0))
end
add(present:rotate('y', 28):translate(-3.55, 0, 1.7))

-- The creatures ------------------------------------------------------------------------------

-- A point on a blob's skin, seen from its middle: `turn` degrees to the right of its nose, at height y.
-- Below the neck (y = 0.196) a blob is a cone, above it a sphere.
local function on_skin(turn, y, out)
  local radius = y > 0.196 and math.sqrt(1 - y * y) or (math.sqrt(26) - y) / 5
  local a = math.rad(turn)
  return out * radius * math.sin(a), y, out * radius * math.cos(a)
end

-- An eye looks along `gaze`, {x, y, z} of length about 1.
local function eye(turn, y, size, gaze)
  local node = gr.node("eye")
  node:add_child(ball("white", {0, 0, 0}, 1, white))
  node:add_child(ball("pupil", {0.5 * gaze[1], 0.5 * gaze[2], 0.5 * gaze[3]}, 0.62, black))
  node:add_child(ball("glint", {0.8 * gaze[1] - 0.2, 0.8 * gaze[2] + 0.28, 0.8 * gaze[3] + 0.22}, 0.13, glint))
  return node:scale(size):translate(on_skin(turn, y, 0.88))
end

-- side is -1 or 1; the arm hangs at 0 degrees, points outward at 90, up at 180.
local function arm(side, degrees, material)
  local node = gr.node("arm")
  node:add_child(egg("sleeve", {0.19, 0.42, 0.19}, material):translate(0, -0.32, 0))
  node:add_child(ball("hand", {0, -0.72, 0}, 0.22, material))
  return node:rotate('z', side * degrees):translate(side * 0.98, 0.02, 0.12)
end

local function creature(is)
  local skin = shiny(is.colour)
  local node = gr.node(is.name)
  node:add_child(gr.blob("body"):set_material(skin))
  node:add_child(eye(-20, 0.42, 0.26, is.gaze))
  node:add_child(eye( 20, 0.42, 0.26, is.gaze))
  node:add_child(egg("cheek", {0.17, 0.12, 0.08}, is.blush):rotate('y', -38):translate(on_skin(-38, 0.08, 0.97)))
  node:add_child(egg("cheek", {0.17, 0.12, 0.08}, is.blush):rotate('y', 38):translate(on_skin(38, 0.08, 0.97)))
  node:add_child(arm(-1, is.arms[1], skin))
  node:add_child(arm(1, is.arms[2], skin))
  for side = -1, 1, 2 do
    node:add_child(egg("foot", {0.34, 0.18, 0.45}, skin):translate(side * 0.5, -0.95, 0.95))
  end
  if is.laughs then
    node:add_child(egg("mouth", {0.26, 0.24, 0.12}, black):rotate('x', 8):translate(on_skin(0, 0.0, 0.97)))
    node:add_child(egg("tongue", {0.16, 0.10, 0.10}, pink):rotate('x', 8):translate(on_skin(0, -0.11, 1.02)))
  else
    -- A ring, tipped so that its upper half is below the skin, is a smile.
    node:add_child(gr.torus("smile", 0.3, 0.034):set_material(black):rotate('x', 90 - 26):translate(on_skin(0, 0.10, 0.93)))
  end
  if is.hat then
    local hat = gr.node("hat"):set_material(is.hat)
    hat:add_child(gr.cone("cone"):scale(0.5, 1.1, 0.5))
    hat:add_child(gr.torus("brim", 0.5, 0.07):set_material(white))
    hat:add_child(gr.nh_sphere("bobble", {0, 1.1, 0}, 0.17):set_material(white))
    node:add_child(hat:translate(0, 0.86, 0):rotate('z', -10))
  end
  return node:translate(0, 1, 0)   -- stands on the floor
end

local bo = creature{name = "Bo", colour = {0.03, 0.40, 0.42}, blush = shiny{0.55, 0.35, 0.40}, gaze = {0.55, 0.35, 0.76},
                    arms = {25, 150}, hat = red}
add(bo:scale(1.15):rotate('y', 12):translate(-2.1, 0, 0))

local pip = creature{name = "Pip", colour = {0.95, 0.62, 0.08}, blush = shiny{0.9, 0.35, 0.15}, gaze = {-0.3, -0.25, 0.92},
                     arms = {140, 140}, laughs = true}
-- The swimming ring: cells of the checker so large that each quarter of the ring lies in another.
pip:add_child(gr.torus("ring", 1.28, 0.27):set_material(white):set_texture(gr.checker({0.75, 0.05, 0.05}, {0.9, 0.88, 0.85}, 10))
  :rotate('y', 45):translate(0, -0.5, 0))
add(pip:scale(0.85):rotate('z', -12):rotate('y', -14):translate(1.3, 1.3, 0.3)
  :motion{from = {translate = {0, -0.045, 0}}, to = {translate = {0, 0.045, 0}}})

-- The moon, outside: dark stone in a bright sun, so that its far side is night. Craters are noise through
-- a ramp of heights: floor, wall, rim, plain. ---------------------------------------------------

local moon = gr.sphere("moon"):set_material(gr.material{kd = 1})
moon:perlin_noise{seed = 12, octaves = {{scale = 1.15, weight = 1}, {scale = 2.6, weight = 0.5}, {scale = 6, weight = 0.25},
    {scale = 14, weight = 0.2}},
  ramp = {{0.32, {0.11, 0.105, 0.10}}, {0.46, {0.18, 0.175, 0.165}}, {0.54, {0.34, 0.33, 0.31}}, {0.72, {0.45, 0.44, 0.41}}}}
local crater = {{0.14, 0.1}, {0.22, 0}, {0.28, 0.2}, {0.33, 1}, {0.37, 0.8}, {0.44, 0.6}}
for i, scale in ipairs{2.6, 6.1, 13.7} do
  moon:perlin_noise{on = "bump", add = true, seed = 20 + i, strength = 0.1 / scale, octaves = {{scale = scale}}, ramp = crater}
end
add(moon:rotate('x', 20):rotate('y', -35):scale(1.38):translate(4.85, 3.72, -12))
for i = 1, 40 do   -- stars
  add(ball("star", {-0.4 + (i * 5.37) % 9.6, (i * 3.713) % 6.4, -20}, 0.02 + 0.012 * (i % 3), glint))
end

-- Light and camera ---------------------------------------------------------------------------

local lights = {
  -- At the ceiling: a rectangle, so that shadows are soft; to the left, so that they show what is round.
  gr.light{position = {-3.4, 7.4, 4.0}, u = {2.4, 0, 0}, v = {0, 0, 1.6}, visible = true,
           colour = {1.9, 1.7, 1.4}, falloff = {0.6, 0, 0.015}},
  gr.light{position = {24, 16, 4}, colour = {2.6, 2.44, 2.04}},     -- the sun, on the moon
}

gr.render{scene = room, file = "blobs.png", size = {1280, 720}, max_error = 0.01,
  camera = {eye = {0.3, 3.0, 10.3}, look_at = {0.3, 1.95, 0}, fov = 34},
  ambient = {0.10, 0.105, 0.14}, lights = lights,
  background = {top = {0.006, 0.012, 0.05}, bottom = {0.03, 0.05, 0.14}}}
