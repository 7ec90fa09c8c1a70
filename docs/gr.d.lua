---@meta
-- What scene scripts can call, for editors. Written out from the tables in src/lua
-- (bindings.cpp, shapes.cpp); a test says how when it is out of date.

---A colour {r, g, b}, or one number for a grey; linear, not negative.
---@alias gr.Colour number|number[]

---@class gr.Material
---@class gr.Light
---@class gr.Texture

---@class gr.Pose
---@field translate? number[]
---@field rotate? { [1]: 'x'|'y'|'z'|number[], [2]: number } axis and degrees
---@field scale? number|number[]
---@field about? number[]

---@class gr.Node
local Node = {}

---The frame of an animation (--frames, --frame), else nil.
---@type integer?
frame = nil

gr = {}

---A node without a shape, to group others.
---
---Example: `gr.node("group")`
---@param name string
---@return gr.Node
function gr.node(name) end

---A node turned about x, then y, by its initial angles in degrees.
---
---Example: `gr.joint("neck", {-30, 0, 30}, {-60, 0, 60})`
---@param name string
---@param x? number[]
---@param y? number[]
---@return gr.Node
function gr.joint(name, x, y) end

---The unit sphere about the origin.
---
---Example: `gr.sphere("ball")`
---@param name string
---@return gr.Node
function gr.sphere(name) end

---The unit cube, from (0, 0, 0) to (1, 1, 1).
---
---Example: `gr.cube("box")`
---@param name string
---@return gr.Node
function gr.cube(name) end

---The plane y = 0, unbounded, or a centred square with edges of that size.
---
---Example: `gr.plane("floor")`
---@param name string
---@param size? number
---@return gr.Node
function gr.plane(name, size) end

---Radius 1 about the y axis, from y = 0 to 1, closed.
---
---Example: `gr.cylinder("can")`
---@param name string
---@return gr.Node
function gr.cylinder(name) end

---Radius 1 at y = 0, where it is closed; its apex at (0, 1, 0).
---
---Example: `gr.cone("hat")`
---@param name string
---@return gr.Node
function gr.cone(name) end

---All within r of the line from (0, 0, 0) to (0, length, 0): 0.25 and 1, unless given.
---
---Example: `gr.capsule("arm", 1, 0.25)`
---@param name string
---@return gr.Node
---@overload fun(name: string, r: number): gr.Node
---@overload fun(name: string, length: number, r: number): gr.Node
function gr.capsule(name) end

---A ring about the y axis: R = 1, and a tube of radius r = 0.25, unless given.
---
---Example: `gr.torus("ring", 1, 0.25)`
---@param name string
---@return gr.Node
---@overload fun(name: string, r: number): gr.Node
---@overload fun(name: string, R: number, r: number): gr.Node
function gr.torus(name) end

---A rounded head on a truncated cone, from y = -1 to 1.
---
---Example: `gr.blob("gumdrop")`
---@param name string
---@return gr.Node
function gr.blob(name) end

---A sphere by its centre and radius.
---
---Example: `gr.nh_sphere("ball", {0, 1, 0}, 2)`
---@param name string
---@param centre number[]
---@param radius number
---@return gr.Node
function gr.nh_sphere(name, centre, radius) end

---A box by its least corner and its edges.
---
---Example: `gr.nh_box("box", {0, 0, 0}, 2)`
---@param name string
---@param corner number[]
---@param size number|number[]
---@return gr.Node
function gr.nh_box(name, corner, size) end

---Triangles of an OBJ file, or of tables; faces count vertices from 0.
---
---Example: `gr.mesh("cow", "cow.obj")`
---@param name string
---@param file string
---@return gr.Node
---@overload fun(name: string, vertices: number[][], faces: number[][]): gr.Node
function gr.mesh(name, file) end

---A Phong material.
---
---Example: `gr.material({0.8, 0.2, 0.2}, {0.5, 0.5, 0.5}, 25)`
---@param kd gr.Colour
---@param ks gr.Colour
---@param shininess number
---@param ior? number
---@param opacity? number
---@param glossiness? number
---@return gr.Material
---@overload fun(fields: { kd?: gr.Colour, ks?: gr.Colour, shininess?: number, ior?: number, opacity?: number, glossiness?: number, reflectivity?: gr.Colour, absorption?: gr.Colour, emission?: gr.Colour }): gr.Material
function gr.material(kd, ks, shininess, ior, opacity, glossiness) end

---A light that dims as 1 / (c0 + c1 d + c2 d^2).
---
---Example: `gr.light({0, 10, 5}, {1, 1, 1}, {1, 0, 0})`
---@param position number[]
---@param colour gr.Colour
---@param falloff number[]
---@param radius? number
---@return gr.Light
---@overload fun(fields: { position: number[], colour?: gr.Colour, falloff?: number[], radius?: number, u?: number[], v?: number[], visible?: boolean, to?: number[] }): gr.Light
function gr.light(position, colour, falloff, radius) end

---A solid checker of cubes with edges of that size (1 unless given) in model space.
---
---Example: `gr.checker({1, 1, 1}, {0, 0, 0}, 0.5)`
---@param even gr.Colour
---@param odd gr.Colour
---@param size? number
---@return gr.Texture
function gr.checker(even, odd, size) end

---A picture (PNG, JPEG, BMP, TGA, TIFF, EXR, HDR) laid on by the surface's coordinates times `scale`; `wrap` says what is beyond it: repeat, clamp, mirror or black.
---
---Example: `gr.texture("brick.jpg", {2, 2})`
---@param file string
---@param scale? number[]
---@return gr.Texture
---@overload fun(fields: { file: string, scale?: number[], wrap?: string }): gr.Texture
function gr.texture(file, scale) end

---Renders the graph as it is now into a picture file.
---
---Example: `gr.render{scene = root, file = "a.png", size = {640, 480}, camera = {eye = {0, 0, 5}, look_at = {0, 0, 0}}, lights = {l}}`
---@param scene gr.Node
---@param file string
---@param width number
---@param height number
---@param eye number[]
---@param view number[]
---@param up number[]
---@param fov number
---@param ambient gr.Colour
---@param lights gr.Light[]
---@param options? table
---@overload fun(fields: { scene: gr.Node, file: string, size: number[], camera: { eye: number[], view?: number[], look_at?: number[], up?: number[], fov?: number, aperture?: number, focus?: number, to?: { eye?: number[], view?: number[], look_at?: number[], up?: number[], fov?: number } }, ambient?: gr.Colour, lights?: gr.Light[], background?: gr.Colour|{ top: gr.Colour, bottom: gr.Colour }, shutter?: number[], samples?: number, max_error?: number, max_samples?: number, time_limit?: number, filter?: string, aa?: string, seed?: number, max_depth?: number, encoding?: string, accel?: string, reflection?: boolean, refraction?: boolean, soft_shadows?: boolean, glossy?: boolean, antialiasing?: boolean, adaptive?: boolean, motion_blur?: boolean, textures?: boolean, noise?: boolean, texture_filter?: boolean, acceleration?: boolean })
function gr.render(scene, file, width, height, eye, view, up, fov, ambient, lights, options) end

---Puts a node below this one; a node may have several parents.
---
---Example: `node:add_child(child)`
---@param child gr.Node
---@return gr.Node
function Node:add_child(child) end

---Gives the node, and those below it that have none, a material.
---
---Example: `node:set_material(material)`
---@param material gr.Material
---@return gr.Node
function Node:set_material(material) end

---Lets a texture, or the picture of a file, stand for the material's "kd" (unless a slot is given), "ks" or "opacity", or be its "bump" or "normal" map of that strength (1).
---
---Example: `node:set_texture(gr.checker({1, 1, 1}, {0, 0, 0}, 1))`
---@param texture gr.Texture|string
---@param slot? string
---@param strength? number
---@return gr.Node
function Node:set_texture(texture, slot, strength) end

---Paints the node with noise of kind "fbm", "turbulence", "marble" or "wood", from one colour to another or along a ramp, on "kd", "ks", "opacity" or "bump" (with add = true on top of the bumps there are).
---
---Example: `node:perlin_noise{octaves = {{scale = 4, weight = 1}}, low = 0.1, high = 0.9}`
---@param fields { octaves?: { scale: number, weight?: number }[], low?: gr.Colour, high?: gr.Colour, ramp?: { [1]: number, [2]: gr.Colour }[], seed?: number, kind?: string, on?: string, add?: boolean, strength?: number }
---@return gr.Node
function Node:perlin_noise(fields) end

---Moves the node.
---
---Example: `node:translate(1, 0, 0)`
---@param x number
---@param y number
---@param z number
---@return gr.Node
function Node:translate(x, y, z) end

---Turns the node about an axis of its parent.
---
---Example: `node:rotate('y', 90)`
---@param axis 'x'|'y'|'z'
---@param degrees number
---@return gr.Node
function Node:rotate(axis, degrees) end

---Scales the node about its parent's origin.
---
---Example: `node:scale(2, 2, 2)`
---@param x number
---@param y number
---@param z number
---@return gr.Node
---@overload fun(self: gr.Node, factor: number): gr.Node
function Node:scale(x, y, z) end

---Moves the node while the shutter is open, about its parent's origin after its transforms. A pose is a table of translate, rotate = {axis, degrees}, scale, about; the function gives that of a time from 0 to 1.
---
---Example: `node:motion{to = {translate = {1, 0, 0}, rotate = {"y", 90}}}`
---@param fields { from?: gr.Pose, to: gr.Pose }
---@return gr.Node
---@overload fun(self: gr.Node, pose_at: function): gr.Node
function Node:motion(fields) end

---Runs name.lua of the script's folder, once, and returns its result.
---
---Example: `require "shapes"`
---@param name string
---@return any
function require(name) end

---Runs a file of the script's folder and returns its results.
---
---Example: `dofile "shapes.lua"`
---@param file string
---@return any
function dofile(file) end
