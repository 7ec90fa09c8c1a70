-- Writes vase.obj on standard output: a turned vase, quads with vertex normals and texture
-- coordinates (u around it, from 0 to 1 at the seam; v along its outline).
-- Run with an ordinary Lua: lua5.3 make_vase.lua > vase.obj
local profile = {{0.0, 0.0}, {0.55, 0.0}, {0.62, 0.05}}
for i = 0, 24 do
  local t = i / 24
  local y = 0.05 + 2.3 * t
  local r = 0.62 + 0.42 * math.sin(math.pi * t * 1.05) - 0.36 * t + 0.2 * t ^ 6
  profile[#profile + 1] = {r, y}
end
-- The lip, and back down inside.
local outer = #profile
profile[#profile + 1] = {profile[outer][1] - 0.07, profile[outer][2] + 0.01}
for i = 24, 1, -1 do
  local p = profile[3 + i]
  profile[#profile + 1] = {p[1] - 0.08, math.max(p[2], 0.1)}
end
profile[#profile + 1] = {0.0, 0.1}

local around = 48
local rows = {}
print("# a vase, turned about the y axis")
local count = 0
for i, p in ipairs(profile) do
  local a, b = profile[math.max(i - 1, 1)], profile[math.min(i + 1, #profile)]
  local dr, dy = b[1] - a[1], b[2] - a[2]
  local length = math.sqrt(dr * dr + dy * dy)
  for j = 0, around - 1 do
    local angle = 2 * math.pi * j / around
    local c, s = math.cos(angle), math.sin(angle)
    print(string.format("v %.5f %.5f %.5f", p[1] * c, p[2], p[1] * s))
    print(string.format("vn %.5f %.5f %.5f", dy / length * c, -dr / length, dy / length * s))
  end
  for j = 0, around do
    print(string.format("vt %.5f %.5f", j / around, (i - 1) / (#profile - 1)))
  end
  rows[i] = count
  count = count + around
end
for i = 1, #profile - 1 do
  for j = 0, around - 1 do
    local k = (j + 1) % around
    local a, b, c, d = rows[i] + j + 1, rows[i + 1] + j + 1, rows[i + 1] + k + 1, rows[i] + k + 1
    local ta = (i - 1) * (around + 1) + j + 1
    local tb = ta + around + 1
    local function corner(v, t) return string.format(" %d/%d/%d", v, t, v) end
    if profile[i][1] == 0 then
      print("f" .. corner(a, ta) .. corner(b, tb) .. corner(c, tb + 1))
    elseif profile[i + 1][1] == 0 then
      print("f" .. corner(a, ta) .. corner(b, tb) .. corner(d, ta + 1))
    else
      print("f" .. corner(a, ta) .. corner(b, tb) .. corner(c, tb + 1) .. corner(d, ta + 1))
    end
  end
end
