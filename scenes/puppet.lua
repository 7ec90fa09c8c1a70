-- A puppet: nodes within nodes. Turning a joint turns all that hangs from it.
local skin = gr.material({0.85, 0.6, 0.45}, {0.2, 0.2, 0.2}, 20)
local shirt = gr.material({0.2, 0.35, 0.7}, {0.3, 0.3, 0.3}, 30)
local trousers = gr.material({0.3, 0.3, 0.33}, {0.2, 0.2, 0.2}, 20)
local shoe = gr.material({0.45, 0.15, 0.1}, {0.5, 0.5, 0.5}, 60)
local button = gr.material({0.9, 0.75, 0.2}, {0.6, 0.6, 0.6}, 80)
local ink = gr.material({0.05, 0.05, 0.06}, {0.6, 0.6, 0.6}, 100)
local floor = gr.material({0.7, 0.66, 0.6}, {0, 0, 0}, 1)

-- A limb hangs from its joint at the origin, along -y, and ends in `tip`.
local function limb(name, length, thickness, material, tip)
  local joint = gr.joint(name, {-90, 0, 90}, {-90, 0, 90})
  local bone = gr.sphere(name .. " bone")
  bone:scale(thickness, 0.55 * length, thickness):translate(0, -0.5 * length, 0)
  bone:set_material(material)
  joint:add_child(bone)
  if tip then
    tip:translate(0, -length, 0)
    joint:add_child(tip)
  end
  return joint
end

local function ball(name, radius, material)
  local node = gr.sphere(name)
  node:scale(radius, radius, radius)
  node:set_material(material)
  return node
end

local function arm(side, shoulder, elbow)
  local lower = limb("lower arm", 0.75, 0.15, skin, ball("hand", 0.19, skin))
  lower:rotate("z", side * elbow)
  local upper = limb("upper arm", 0.75, 0.2, shirt, lower)
  upper:rotate("z", side * shoulder):translate(side * 0.62, 0.72, 0)
  return upper
end

local function leg(side, hip, knee)
  local foot = gr.sphere("foot")
  foot:set_material(shoe)
  foot:scale(0.2, 0.14, 0.34):translate(0, 0, 0.14)
  local lower = limb("shin", 0.9, 0.17, trousers, foot)
  lower:rotate("x", knee)
  local upper = limb("thigh", 0.85, 0.24, trousers, lower)
  upper:rotate("x", hip):rotate("z", side * 7):translate(side * 0.32, -0.75, 0)
  return upper
end

local puppet = gr.node("puppet")
local torso = gr.node("torso")
local chest = gr.sphere("chest")
chest:set_material(shirt)
chest:scale(0.65, 0.95, 0.42)
torso:add_child(chest)
for i = -1, 1 do
  torso:add_child(ball("button", 0.07, button):translate(0, 0.3 * i, 0.41 - 0.03 * math.abs(i)))
end

local head = gr.node("head")
head:add_child(ball("skull", 0.48, skin))
for side = -1, 1, 2 do
  head:add_child(ball("eye", 0.07, ink):translate(side * 0.17, 0.1, 0.43))
end
head:add_child(ball("nose", 0.1, shoe):translate(0, -0.04, 0.5))
local smile = gr.torus("smile", 0.2, 0.025)
smile:set_material(ink)
smile:rotate("x", 75):translate(0, -0.16, 0.33)
head:add_child(smile)
local brim = gr.cylinder("brim")
brim:scale(0.6, 0.05, 0.6):translate(0, 0.3, 0)
brim:set_material(trousers)
local crown = gr.cylinder("crown")
crown:scale(0.36, 0.5, 0.36):translate(0, 0.33, 0)
crown:set_material(trousers)
head:add_child(brim)
head:add_child(crown)
head:rotate("z", -10):rotate("y", 12):translate(0, 1.38, 0)
torso:add_child(head)

torso:add_child(arm(1, 125, 30))
torso:add_child(arm(-1, 35, -60))
torso:add_child(leg(1, -40, 65))
torso:add_child(leg(-1, 4, 6))
torso:rotate("z", 4):translate(0, 2.62, 0)
puppet:add_child(torso)

local scene = gr.node("scene")
scene:add_child(puppet)
local ground = gr.plane("ground")
ground:set_material(floor)
scene:add_child(ground)

gr.render(scene, "puppet.png", 512, 512,
  {1.5, 3, 9}, {-0.15, -0.07, -1}, {0, 1, 0}, 36,
  {0.28, 0.28, 0.3},
  {gr.light({4, 8, 7}, {0.75, 0.72, 0.68}, {1, 0, 0}),
   gr.light({-6, 5, 5}, {0.22, 0.24, 0.3}, {1, 0, 0})},
  {background = {top = {0.35, 0.5, 0.75}, bottom = {0.85, 0.88, 0.92}}})
