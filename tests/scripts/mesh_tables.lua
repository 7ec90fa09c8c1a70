-- Vertices and faces in tables: polygons of any size, counted from 0.
local roof = {}
local n = 7
for i = 0, n - 1 do
  local a = 2 * math.pi * i / n
  roof[#roof + 1] = {math.cos(a), 0, math.sin(a)}
end
for i = 0, n - 1 do
  local a = 2 * math.pi * i / n
  roof[#roof + 1] = {0.6 * math.cos(a), 1, 0.6 * math.sin(a)}
end
local faces = {{}, {}}
for i = 0, n - 1 do
  faces[1][#faces[1] + 1] = i
  faces[2][#faces[2] + 1] = 2 * n - 1 - i
  faces[#faces + 1] = {i, n + i, n + (i + 1) % n, (i + 1) % n}
end
local tower = gr.mesh('tower', roof, faces)
tower:set_material(gr.material({0.7, 0.4, 0.3}, {0.1, 0.1, 0.1}, 5))
gr.render(tower, 'tables.png', 64, 48, {0, 2, 4}, {0, -1.5, -4}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {1, 1, 1}, {1, 0, 0})})
