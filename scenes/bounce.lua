-- Three blobs hop on a drum each: a film of 48 frames, two seconds that can be played in a loop.
--   mkdir -p film && raytracer scenes/bounce.lua --frames 0..47 -o film/
--   ffmpeg -framerate 24 -i film/bounce_%04d.png -pix_fmt yuv420p bounce.mp4
local frames = 48
local now = frame or 10   -- the global `frame` is set by --frames and --frame; else one of the hop

local scene = gr.node("scene")
local function shiny(colour) return gr.material{kd = colour, ks = 0.5, shininess = 60, reflectivity = 0.05} end
local white, black = shiny{0.9, 0.9, 0.88}, shiny{0.02, 0.02, 0.03}

-- Where a hopper is at phase p, 0 to 1: it sinks into its drum for a quarter of the time and flies
-- for the rest. What grows in height shrinks in width, so that its volume stays the same.
local function pose(p)
  local height, stretch
  if p < 0.25 then
    height, stretch = 0, 1 - 0.38 * math.sin(math.pi * p / 0.25) ^ 2
  else
    local q = (p - 0.25) / 0.75                           -- of the flight
    height, stretch = 1.7 * 4 * q * (1 - q), 1 + 0.2 * math.sin(2 * math.pi * q) ^ 2
  end
  local width = 1 / math.sqrt(stretch)
  return {scale = {width, stretch, width}, translate = {0, height, 0}}
end

-- A blob that stands on y = 0, with eyes.
local function hopper(colour)
  local body = gr.node("hopper")
  body:add_child(gr.blob("body"):set_material(shiny(colour)))
  for side = -1, 1, 2 do
    body:add_child(gr.nh_sphere("eye", {0.32 * side, 0.42, 0.80}, 0.24):set_material(white))
    body:add_child(gr.nh_sphere("pupil", {0.30 * side, 0.46, 0.95}, 0.13):set_material(black))
    body:add_child(gr.sphere("foot"):set_material(shiny(colour)):scale(0.34, 0.16, 0.42):translate(0.5 * side, -0.9, 0.9))
  end
  -- A ring, tipped so that its upper half is below the skin, is a smile.
  body:add_child(gr.torus("smile", 0.25, 0.035):set_material(black):rotate('x', 64):translate(0, 0.1, 0.93))
  return body:translate(0, 1, 0)
end

for i, colour in ipairs{{0.85, 0.22, 0.16}, {0.95, 0.62, 0.08}, {0.06, 0.50, 0.50}} do
  local start = i / 3                                     -- they hop one after another
  local place = gr.node("place")
  place:add_child(gr.cylinder("drum"):set_material(white):scale(1.35, 0.5, 1.35))
  place:add_child(gr.torus("hoop", 1.36, 0.06):set_material(shiny(colour)):translate(0, 0.47, 0))
  -- The shutter is open for t from 0 to 1/2: half of the time from this frame to the next.
  local flyer = hopper(colour):motion(function(t) return pose((start + (now + t) / frames) % 1) end)
  place:add_child(gr.node("above"):translate(0, 0.5, 0):add_child(flyer))
  scene:add_child(place:translate(3.3 * (i - 2), 0, 0))
end
scene:add_child(gr.plane("ground"):set_material(gr.material{kd = 1})
  :set_texture(gr.checker({0.62, 0.58, 0.66}, {0.50, 0.47, 0.58}, 1.5)):translate(0, -0.001, 0))

gr.render{scene = scene, file = "bounce.png", size = {640, 360}, shutter = {0, 0.5},
  camera = {eye = {0, 3.4, 12.5}, look_at = {0, 1.95, 0}, fov = 32}, ambient = {0.24, 0.24, 0.28},
  lights = {gr.light{position = {-5, 10, 7}, colour = {0.9, 0.86, 0.78}, radius = 1.2}},
  background = {top = {0.25, 0.42, 0.75}, bottom = {0.86, 0.82, 0.86}}}
