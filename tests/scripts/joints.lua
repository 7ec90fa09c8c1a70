-- A puppet's leg: joints with ranges, turned at first and later.
local skin = gr.material({0.8, 0.6, 0.5}, {0.1, 0.1, 0.1}, 10)
local function bone(name, length)
  return gr.sphere(name):scale(0.2, length / 2, 0.2):translate(0, -length / 2, 0):set_material(skin)
end
local hip = gr.joint('hip', {-90, 30, 90}, {0, 0, 0})
hip:add_child(bone('thigh', 2))
local knee = gr.joint('knee', {-120, -60, 0})
knee:add_child(bone('shin', 1.8))
local below = gr.node('below')
below:translate(0, -2, 0)
below:add_child(knee)
hip:add_child(below)
hip:rotate('z', 20)
hip:translate(0, 2, 0)
gr.render(hip, 'leg.png', 48, 64, {4, 0, 8}, {-0.5, 0, -1}, {0, 1, 0}, 45, {0.3, 0.3, 0.3},
          {gr.light({5, 5, 5}, {0.7, 0.7, 0.7}, {1, 0, 0})})
