/// The one table that says what scripts can call. Its rows for shapes are in shapes.cpp.
#include <array>
#include <vector>

#include "functions.h"
#include "guarded.h"

namespace rt::lua {
namespace {

constexpr std::array table{
    Binding{"gr.material", guarded<make_material>, 6,
            "(kd: colour, ks: colour, shininess: number, ior?: number, opacity?: number, "
            "glossiness?: number) or {kd?: colour, ks?: colour, shininess?: number, ior?: number, "
            "opacity?: number, glossiness?: number, reflectivity?: colour, absorption?: colour, "
            "emission?: colour}: material",
            "A Phong material.", "gr.material({0.8, 0.2, 0.2}, {0.5, 0.5, 0.5}, 25)"},
    Binding{"gr.light", guarded<make_light>, 4,
            "(position: {x, y, z}, colour: colour, falloff: {c0, c1, c2}, radius?: number) or "
            "{position: {x, y, z}, colour?: colour, falloff?: {c0, c1, c2}, radius?: number, "
            "u?: {x, y, z}, v?: {x, y, z}, visible?: boolean, to?: {x, y, z}}: light",
            "A light that dims as 1 / (c0 + c1 d + c2 d^2).",
            "gr.light({0, 10, 5}, {1, 1, 1}, {1, 0, 0})"},
    Binding{"gr.checker", guarded<make_checker>, 3,
            "(even: colour, odd: colour, size?: number): texture",
            "A solid checker of cubes with edges of that size (1 unless given) in model space.",
            "gr.checker({1, 1, 1}, {0, 0, 0}, 0.5)"},
    Binding{"gr.texture", guarded<make_texture>, 2,
            "(file: string, scale?: {u, v}) or {file: string, scale?: {u, v}, wrap?: string}: "
            "texture",
            "A picture (PNG, JPEG, BMP, TGA, TIFF, EXR, HDR) laid on by the surface's coordinates "
            "times `scale`; `wrap` says what is beyond it: repeat, clamp, mirror or black.",
            R"(gr.texture("brick.jpg", {2, 2}))"},
    Binding{
        "gr.render", guarded<render>, 11,
        "(scene: node, file: string, width: number, height: number, eye: {x, y, z}, view: {x, "
        "y, z}, up: {x, y, z}, fov: number, ambient: colour, lights: {light, ...}, options?: "
        "table) or {scene: node, file: string, size: {w, h}, camera: {eye: {x, y, z}, "
        "view?: {x, y, z}, look_at?: {x, y, z}, up?: {x, y, z}, fov?: number, aperture?: number, "
        "focus?: number, to?: {eye?: {x, y, z}, view?: {x, y, z}, look_at?: {x, y, z}, up?: {x, y, "
        "z}, fov?: number}}, "
        "ambient?: colour, lights?: {light, ...}, ...options}",
        "Renders the graph as it is now into a picture file.",
        R"(gr.render{scene = root, file = "a.png", size = {640, 480}, )"
        R"(camera = {eye = {0, 0, 5}, look_at = {0, 0, 0}}, lights = {l}})"},
    Binding{"node:add_child", guarded<node_add_child>, 1, "(child: node): node",
            "Puts a node below this one; a node may have several parents.",
            "node:add_child(child)"},
    Binding{"node:set_material", guarded<node_set_material>, 1, "(material: material): node",
            "Gives the node, and those below it that have none, a material.",
            "node:set_material(material)"},
    Binding{"node:set_texture", guarded<node_set_texture>, 3,
            "(texture: texture or string, slot?: string, strength?: number): node",
            "Lets a texture, or the picture of a file, stand for the material's \"kd\" (unless a "
            "slot is given), \"ks\" or "
            "\"opacity\", or be its \"bump\" or \"normal\" map of that strength (1).",
            "node:set_texture(gr.checker({1, 1, 1}, {0, 0, 0}, 1))"},
    Binding{"node:perlin_noise", guarded<node_perlin_noise>, 1,
            "{octaves?: {{scale: number, weight?: number}, ...}, low?: colour, high?: colour, "
            "ramp?: {{number, colour}, ...}, seed?: number, kind?: string, on?: string, "
            "add?: boolean, strength?: number}: node",
            "Paints the node with noise of kind \"fbm\", \"turbulence\", \"marble\" or \"wood\", "
            "from one colour to another or along a ramp, on \"kd\", \"ks\", \"opacity\" or "
            "\"bump\" (with add = true on top of the bumps there are).",
            "node:perlin_noise{octaves = {{scale = 4, weight = 1}}, low = 0.1, high = 0.9}"},
    Binding{"node:translate", guarded<node_translate>, 3, "(x: number, y: number, z: number): node",
            "Moves the node.", "node:translate(1, 0, 0)"},
    Binding{"node:rotate", guarded<node_rotate>, 2,
            "(axis: 'x', 'y' or 'z', degrees: number): node",
            "Turns the node about an axis of its parent.", "node:rotate('y', 90)"},
    Binding{"node:scale", guarded<node_scale>, 3,
            "(x: number, y: number, z: number) or (factor: number): node",
            "Scales the node about its parent's origin.", "node:scale(2, 2, 2)"},
    Binding{
        "node:motion", guarded<node_motion>, 1,
        "{from?: pose, to: pose} or (pose_at: function): node",
        "Moves the node while the shutter is open, about its parent's origin after its transforms. "
        "A pose is a table of translate, rotate = {axis, degrees}, scale, about; the function "
        "gives that of a time from 0 to 1.",
        R"(node:motion{to = {translate = {1, 0, 0}, rotate = {"y", 90}}})"},
    Binding{"require", guarded<require_module>, 1, "(name: string): any",
            "Runs name.lua of the script's folder, once, and returns its result.",
            R"(require "shapes")"},
    Binding{"dofile", guarded<run_file>, 1, "(file: string): any",
            "Runs a file of the script's folder and returns its results.",
            R"(dofile "shapes.lua")"},
};

}  // namespace

std::span<const Binding> bindings() {
  static const std::vector<Binding> all = [] {
    std::vector<Binding> rows(shape_bindings().begin(), shape_bindings().end());
    rows.insert(rows.end(), table.begin(), table.end());
    return rows;
  }();
  return all;
}

}  // namespace rt::lua
