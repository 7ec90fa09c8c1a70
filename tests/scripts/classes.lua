-- Classes made of tables, which hold nodes.
local Planet = {}
Planet.__index = Planet
function Planet.new(name, radius, distance, colour)
  local self = setmetatable({name = name, moons = 0}, Planet)
  self.orbit = gr.node(name .. ' orbit')
  self.body = gr.sphere(name):scale(radius):translate(distance, 0, 0)
  self.body:set_material(gr.material(colour, {0.1, 0.1, 0.1}, 5))
  self.orbit:add_child(self.body)
  return self
end
function Planet:turn(degrees) self.orbit:rotate('y', degrees) return self end
function Planet:__tostring() return 'planet ' .. self.name end
local sun = Planet.new('sun', 1.5, 0, {0.9, 0.8, 0.3})
for i, name in ipairs{'hermes', 'aphrodite', 'gaia'} do
  local p = Planet.new(name, 0.3 + 0.1 * i, 1.5 + i, {0.3, 0.2 * i, 0.9}):turn(-40 * i)
  assert(tostring(p) == 'planet ' .. name)
  sun.orbit:add_child(p.orbit)
end
gr.render(sun.orbit, 'planets.png', 64, 48, {0, 3, 9}, {0, -0.3, -1}, {0, 1, 0}, 45, {0.3, 0.3, 0.3},
          {gr.light({5, 5, 5}, {0.7, 0.7, 0.7}, {1, 0, 0})})
