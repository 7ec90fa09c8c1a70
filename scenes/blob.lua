-- The blob: a round head that runs smoothly into a body like a gumdrop's.
local colours = {{0.85, 0.3, 0.25}, {0.9, 0.65, 0.2}, {0.35, 0.65, 0.3}, {0.25, 0.45, 0.8}, {0.6, 0.35, 0.7}}
local floor = gr.material({0.75, 0.72, 0.68}, {0, 0, 0}, 1)

local scene = gr.node("scene")
for i, colour in ipairs(colours) do
  local blob = gr.blob("gumdrop" .. i)
  blob:set_material(gr.material(colour, {0.5, 0.5, 0.5}, 50))
  local size = 0.6 + 0.12 * ((i * 2) % 5)
  blob:translate(0, 1, 0):scale(size, size, size):translate(1.55 * (i - 3), 0, -0.5 * (i % 2))
  scene:add_child(blob)
end

-- One that has fallen over shows its base.
local fallen = gr.blob("fallen")
fallen:set_material(gr.material({0.9, 0.85, 0.75}, {0.4, 0.4, 0.4}, 40))
fallen:rotate("x", -78.69):rotate("y", 150):scale(0.6, 0.6, 0.6):translate(0.4, 0.6, 2)
scene:add_child(fallen)

local ground = gr.plane("ground")
ground:set_material(floor)
scene:add_child(ground)

gr.render(scene, "blob.png", 512, 512,
  {0, 3.4, 11}, {0, -0.24, -1}, {0, 1, 0}, 42,
  {0.28, 0.28, 0.3},
  {gr.light({5, 8, 6}, {0.75, 0.74, 0.7}, {1, 0, 0}),
   gr.light({-6, 5, 5}, {0.2, 0.22, 0.28}, {1, 0, 0})},
  {background = {top = {0.35, 0.5, 0.75}, bottom = {0.85, 0.88, 0.92}}})
