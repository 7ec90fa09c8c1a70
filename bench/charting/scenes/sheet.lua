-- A mesh of about N triangles, a rippled sheet that keeps its look whatever N is: sheet.lua -- N
-- [adaptive], which is as in cloud.lua.
local edge = math.max(1, math.floor(math.sqrt(tonumber(arg[1]) / 2) + 0.5))
local vertices, faces = {}, {}
for i = 0, edge do
  for j = 0, edge do
    local x, z = 4 * i / edge - 2, 4 * j / edge - 2
    vertices[#vertices + 1] = {x, 0.4 * math.sin(5 * x) * math.cos(4 * z), z}
    if i < edge and j < edge then
      local a = i * (edge + 1) + j
      faces[#faces + 1] = {a, a + 1, a + edge + 1}
      faces[#faces + 1] = {a + 1, a + edge + 2, a + edge + 1}
    end
  end
end
local sheet = gr.mesh("sheet", vertices, faces)
gr.render {
  scene = sheet:set_material(gr.material {kd = {0.7, 0.5, 0.3}}), file = "sheet.png",
  size = {320, 240}, ambient = 0.2, samples = arg[2] ~= "adaptive" and 1 or nil,
  background = {0.2, 0.3, 0.5},
  camera = {eye = {0.5, 3, 6}, look_at = {0, 0, 0}, fov = 40},
  lights = {gr.light {position = {5, 8, 9}, colour = 0.8}},
}
