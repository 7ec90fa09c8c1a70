-- Renders the scene that is named twice: the second time nothing is left to be loaded.
for _ = 1, 2 do
  dofile(arg[1])
end
