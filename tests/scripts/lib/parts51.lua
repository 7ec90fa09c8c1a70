module('lib.parts51', package.seeall)
count = 0
function part(name)
  count = count + 1
  return gr.nh_sphere(name, {2 * count - 3, 0, 0}, 0.8)
end
