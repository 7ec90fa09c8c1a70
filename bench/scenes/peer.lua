--- Builds a scene of bench/scenes, which is written in terms that every ray tracer knows (a finish of
--- ambient, diffuse, phong and reflection), so that bench/peers.py can give it to others. What the
--- entries of `objects` mean stands in README.md.

local function vector(f, a, b)
  return {f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])}
end
local function minus(a, b)
  return vector(function(x, y) return x - y end, a, b)
end
local function along(a, t, d)  -- a + t d
  return vector(function(x, y) return x + t * y end, a, d)
end
local function times(a, s)
  return {a[1] * s, a[2] * s, a[3] * s}
end
local function cross(a, b)
  return {a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1]}
end
local function length(a)
  return math.sqrt(a[1] * a[1] + a[2] * a[2] + a[3] * a[3])
end
local function grey(value)
  return {value, value, value}
end

--- Turns what stands along the y axis into the direction.
local function turn_y_to(node, direction)
  local x, y, z = direction[1], direction[2], direction[3]
  node:rotate("x", math.deg(math.atan(math.sqrt(x * x + z * z), y)))
  return node:rotate("y", math.deg(math.atan(x, z)))
end

local make = {}

function make.plane(name, height)
  return gr.plane(name):translate(0, height, 0)
end

function make.sphere(name, centre, radius)
  return gr.nh_sphere(name, centre, radius)
end

function make.box(name, centre, half, degrees)
  local box = gr.nh_box(name, times(half, -1), times(half, 2))
  return box:rotate("y", degrees):translate(centre[1], centre[2], centre[3])
end

function make.cylinder(name, a, b, radius)
  local axis = minus(b, a)
  local cylinder = gr.cylinder(name):scale(radius, length(axis), radius)
  return turn_y_to(cylinder, axis):translate(a[1], a[2], a[3])
end

function make.torus(name, centre, axis, major, minor)
  local torus = turn_y_to(gr.torus(name, major, minor), axis)
  return torus:translate(centre[1], centre[2], centre[3])
end

--- A ball with nine of a third its size upon it: six around its equator and three above, where
--- three cubes' corners would meet.
function make.sphereflake(name, centre, radius, levels)
  local elevation = math.rad(54.7356)
  local flake = gr.node(name)
  local function grow(middle, r, up, level)
    flake:add_child(gr.nh_sphere(name, middle, r))
    if level == 0 then
      return
    end
    local helper = math.abs(up[1]) > 0.9 and {0, 0, 1} or {1, 0, 0}
    local w = cross(helper, up)
    w = times(w, 1 / length(w))
    local u = cross(up, w)
    for child = 0, 8 do
      local azimuth = math.rad(child < 6 and 60 * child or 30 + 120 * (child - 6))
      local height = child < 6 and 0 or elevation
      local flat = math.cos(height)
      local d = times(u, math.cos(azimuth) * flat)
      d = along(along(d, math.sin(azimuth) * flat, w), math.sin(height), up)
      d = times(d, 1 / length(d))
      grow(along(middle, r + r / 3, d), r / 3, d, level - 1)
    end
  end
  grow(centre, radius, {0, 1, 0}, levels)
  return flake
end

--- Balls on a square lattice, each touching the plane y = 0 from above.
function make.balls(name, first, material_names, rows, materials)
  local balls = gr.node(name)
  for i, row in ipairs(rows) do
    for j = 1, #row // 5 do
      local digits = row:sub(5 * j - 4, 5 * j)
      local r = tonumber(digits:sub(1, 4)) / 10000
      local ball = gr.nh_sphere(name, {first[1] + i - 1, r, first[2] + j - 1}, r)
      balls:add_child(ball:set_material(materials[material_names[tonumber(digits:sub(5)) + 1]]))
    end
  end
  return balls
end

--- Our material for a finish. The peers' ambient term is colour * ambient: what the scene's ambient
--- light does not give of it (all of it, unless a checker's colour varies) is emission.
local function material(finish, scene_ambient)
  local colour = finish.checker and {0, 0, 0} or finish.color or {0, 0, 0}
  local diffuse = finish.diffuse or 0
  local rest = (finish.ambient or 0) - diffuse * scene_ambient
  return gr.material {
    kd = times(colour, diffuse),
    ks = grey(finish.phong or 0),
    shininess = finish.phong_size or 1,
    reflectivity = grey(finish.reflect or 0),
    ior = finish.glass or 1,
    opacity = finish.glass and 0 or 1,
    emission = times(colour, math.max(rest, 0)),
  }
end

local function render(scene)
  local ambient = 0
  for _, finish in pairs(scene.materials) do
    if finish.checker then
      ambient = finish.ambient / finish.diffuse
    end
  end
  local materials = {}
  for name, finish in pairs(scene.materials) do
    materials[name] = material(finish, ambient)
  end
  local root = gr.node(scene.name)
  for i, object in ipairs(scene.objects) do
    local arguments = {table.unpack(object, 2)}
    arguments[#arguments + 1] = materials
    local node = make[object[1]](object[1] .. i, table.unpack(arguments))
    local name = object[#object]
    local finish = scene.materials[name]
    if finish then
      node:set_material(materials[name])
      if finish.checker then
        local c1, c2, size = table.unpack(finish.checker)
        node:set_texture(gr.checker(times(c1, finish.diffuse), times(c2, finish.diffuse), size))
      end
    end
    root:add_child(node)
  end
  local lights = {}
  for i, light in ipairs(scene.lights) do
    lights[i] = gr.light {
      position = light.position,
      colour = light.color,
      falloff = {1, 0, 0},
      radius = light.radius,
      u = light.u,
      v = light.v,
    }
  end
  gr.render {
    scene = root,
    file = scene.name .. ".png",
    size = scene.size,
    camera = scene.camera,
    background = scene.background,
    ambient = grey(ambient),
    lights = lights,
    max_depth = scene.trace_level - 1,  -- the peers count the camera's ray
  }
end

local reading_base = false

--- Renders the scene. One with a `base` is that file's, with other values for some keys, and
--- `without` one kind of object.
return function(scene)
  if reading_base then
    return scene
  end
  if scene.base then
    reading_base = true
    local base = dofile(scene.base)
    reading_base = false
    local objects = {}
    for _, object in ipairs(base.objects) do
      if object[1] ~= scene.without then
        objects[#objects + 1] = object
      end
    end
    base.objects = objects
    scene = setmetatable(scene, {__index = base})
  end
  render(scene)
end
