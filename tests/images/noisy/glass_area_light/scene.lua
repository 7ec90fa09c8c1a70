-- Glass and a milky ball under a rectangular light: branches chosen by chance; "wrong": the glass'
-- index is 1.52 for 1.5.
local wrong = arg[1] == "wrong"
local scene = gr.node("scene")
local function add(node, material)
  node:set_material(material)
  scene:add_child(node)
end
local function glass(opacity)
  return gr.material{kd = {0.8, 0.4, 0.2}, ks = {0.3, 0.3, 0.3}, shininess = 20, ior = wrong and 1.52 or 1.5,
                     opacity = opacity, absorption = {0.3, 0.1, 0.2}}
end
add(gr.plane("ground"), gr.material({0.8, 0.75, 0.7}, {0, 0, 0}, 1))
add(gr.nh_sphere("clear", {-0.7, 0.7, 0}, 0.6), glass(0))
add(gr.nh_sphere("milky", {0.7, 0.6, 0.3}, 0.5), glass(0.5))
add(gr.nh_box("box", {-1.5, 0, -2}, {3, 1.2, 0.4}), gr.material({0.2, 0.4, 0.7}, {0, 0, 0}, 1))
gr.render(scene, "scene.exr", 64, 48, {0, 2, 5}, {0, -0.3, -1}, {0, 1, 0}, 36, {0.1, 0.1, 0.1},
  {gr.light{position = {-1, 4, 1}, colour = {0.8, 0.8, 0.8}, u = {1.5, 0, 0}, v = {0, 0, 1.5}}},
  {samples = 64, background = {0.5, 0.6, 0.8}})
