-- Motion blur: a ball across, a wheel, a ball that jumps along an arc.
local root = gr.node("root")
root:add_child(gr.plane("floor"):set_material(gr.material{kd = {0.6, 0.6, 0.55}}))
local function ball(x, c) return gr.nh_sphere("b", {x, 0.5, 0}, 0.5):set_material(gr.material{kd=c, ks=0.5, shininess=50}) end
root:add_child(ball(-3, {0.8,0.2,0.1}):motion{to={translate={1.5,0,0}}})
local wheel = gr.node("wheel")
for i=0,2 do wheel:add_child(gr.nh_box("spoke", {-1,-0.05,-0.05},{1,0.1,0.1}):rotate("z",120*i):set_material(gr.material{kd={0.2,0.4,0.8}})) end
root:add_child(wheel:translate(0,1.2,0):motion{to={rotate={'z', 60}, about={0,1.2,0}}})
root:add_child(ball(2.5, {0.2,0.7,0.2}):motion(function(t) return {translate={0, math.sin(math.pi*t), 0}, scale=1} end))
gr.render{scene=root, file="moving.png", size={320,200}, ambient=0.2, background={0.5,0.6,0.8}, camera={eye={0,2,8}, look_at={0,0.8,0}, fov=40}, lights={gr.light{position={4,6,5}, colour=0.8}}}
