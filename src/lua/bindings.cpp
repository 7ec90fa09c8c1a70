/// The one table that says what scripts can call, and how it gets into a Lua state.
#include <fmt/format.h>

#include <array>
#include <vector>

#include "binding.h"
#include "describe.h"
#include "functions.h"
#include "guarded.h"
#include "handle.h"
#include "nodes.h"

namespace rt::lua {
namespace {

constexpr std::array table{
    Binding{"gr.node", guarded<make_node>, 1, "(name: string): node",
            "A node without a shape, to group others.", R"(gr.node("group"))"},
    Binding{"gr.joint", guarded<make_joint>, 3,
            "(name: string, x?: {min, init, max}, y?: {min, init, max}): node",
            "A node turned about x, then y, by its initial angles in degrees.",
            R"(gr.joint("neck", {-30, 0, 30}, {-60, 0, 60}))"},
    Binding{"gr.sphere", guarded<make_sphere>, 1, "(name: string): node",
            "The unit sphere about the origin.", R"(gr.sphere("ball"))"},
    Binding{"gr.cube", guarded<make_cube>, 1, "(name: string): node",
            "The unit cube, from (0, 0, 0) to (1, 1, 1).", R"(gr.cube("box"))"},
    Binding{"gr.plane", guarded<make_plane>, 2, "(name: string, size?: number): node",
            "The plane y = 0, unbounded, or a centred square with edges of that size.",
            R"(gr.plane("floor"))"},
    Binding{"gr.cylinder", guarded<make_cylinder>, 1, "(name: string): node",
            "Radius 1 about the y axis, from y = 0 to 1, closed.", R"(gr.cylinder("can"))"},
    Binding{"gr.cone", guarded<make_cone>, 1, "(name: string): node",
            "Radius 1 at y = 0, where it is closed; its apex at (0, 1, 0).", R"(gr.cone("hat"))"},
    Binding{"gr.torus", guarded<make_torus>, 3,
            "(name: string), (name: string, r: number) or (name: string, R: number, r: number): "
            "node",
            "A ring about the y axis: R = 1, and a tube of radius r = 0.25, unless given.",
            R"(gr.torus("ring", 1, 0.25))"},
    Binding{"gr.blob", guarded<make_blob>, 1, "(name: string): node",
            "A rounded head on a truncated cone, from y = -1 to 1.", R"(gr.blob("gumdrop"))"},
    Binding{"gr.nh_sphere", guarded<make_nh_sphere>, 3,
            "(name: string, centre: {x, y, z}, radius: number): node",
            "A sphere by its centre and radius.", R"(gr.nh_sphere("ball", {0, 1, 0}, 2))"},
    Binding{"gr.nh_box", guarded<make_nh_box>, 3,
            "(name: string, corner: {x, y, z}, size: number or {sx, sy, sz}): node",
            "A box by its least corner and its edges.", R"(gr.nh_box("box", {0, 0, 0}, 2))"},
    Binding{"gr.mesh", guarded<make_mesh>, 3,
            "(name: string, file: string) or (name: string, vertices: {{x, y, z}, ...}, faces: "
            "{{0, 1, 2}, ...}): node",
            "Triangles of an OBJ file, or of tables; faces count vertices from 0.",
            R"(gr.mesh("cow", "cow.obj"))"},
    Binding{"gr.material", guarded<make_material>, 6,
            "(kd: colour, ks: colour, shininess: number, ior?: number, opacity?: number, "
            "glossiness?: number) or {kd?: colour, ks?: colour, shininess?: number, ior?: number, "
            "opacity?: number, glossiness?: number, reflectivity?: colour, absorption?: colour, "
            "emission?: colour}: material",
            "A Phong material.", "gr.material({0.8, 0.2, 0.2}, {0.5, 0.5, 0.5}, 25)"},
    Binding{"gr.light", guarded<make_light>, 4,
            "(position: {x, y, z}, colour: colour, falloff: {c0, c1, c2}, radius?: number) or "
            "{position: {x, y, z}, colour?: colour, falloff?: {c0, c1, c2}, radius?: number, "
            "u?: {x, y, z}, v?: {x, y, z}, visible?: boolean}: light",
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
    Binding{"gr.render", guarded<render>, 11,
            "(scene: node, file: string, width: number, height: number, eye: {x, y, z}, view: {x, "
            "y, z}, up: {x, y, z}, fov: number, ambient: colour, lights: {light, ...}, options?: "
            "table) or {scene: node, file: string, size: {w, h}, camera: {eye: {x, y, z}, "
            "view?: {x, y, z}, look_at?: {x, y, z}, up?: {x, y, z}, fov?: number}, "
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
            "{octaves?: {{scale: number, weight: number}, ...}, low?: colour, high?: colour, "
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
        "{from? = pose, to = pose} or (function(t) return pose end): node",
        "Moves the node while the shutter is open, t from 0 to 1, about its parent's origin after "
        "its transforms. A pose is a table of translate, rotate = {axis, degrees}, scale, about.",
        R"(node:motion{to = {translate = {1, 0, 0}, rotate = {"y", 90}}})"},
    Binding{"require", guarded<require_module>, 1, "(name: string): any",
            "Runs name.lua of the script's folder, once, and returns its result.",
            R"(require "shapes")"},
    Binding{"dofile", guarded<run_file>, 1, "(file: string): any",
            "Runs a file of the script's folder and returns its results.",
            R"(dofile "shapes.lua")"},
};

/// The names that begin with `prefix`, without it.
std::vector<std::string_view> names_in(std::string_view prefix) {
  std::vector<std::string_view> names;
  for (const Binding& binding : table) {
    if (binding.title.starts_with(prefix)) {
      names.push_back(binding.name());
    }
  }
  return names;
}

std::string key_text(lua_State* L, int index) {
  return lua_type(L, index) == LUA_TSTRING ? shortened(lua_tostring(L, index)) : describe(L, index);
}

/// What a skipped method does: it returns its node.
int return_first(lua_State* L) {
  lua_settop(L, 1);
  return 1;
}

/// __index of gr: reached for what is not there.
int unknown_function(lua_State* L) {
  const std::string key = key_text(L, 2);
  const std::string text = fmt::format("there is no gr.{}", key);
  if (!context(L).settings.lenient) {
    throw SceneError(text + suggestion(key, names_in("gr.")));
  }
  warn_once(L, text, text + "; an empty node stands for what it makes");
  lua_pushcfunction(L, guarded<push_stand_in>);
  return 1;
}

/// __index of the methods' table: reached for what is not there, of a node (argument 1).
int unknown_method(lua_State* L) {
  const std::string key = key_text(L, 2);
  const std::string text = fmt::format("nodes have no method '{}'", key);
  if (!context(L).settings.lenient) {
    throw SceneError(text + suggestion(key, names_in("node:")));
  }
  warn_once(L, text, text + "; the call is skipped");
  lua_pushcfunction(L, return_first);
  return 1;
}

/// __index of materials, lights and textures.
template <class T>
int no_method(lua_State* L) {
  throw SceneError(fmt::format("a {} has no '{}'; only nodes have methods", handle_kind<T>.name,
                               key_text(L, 2)));
}

int refuse_assignment(lua_State* L) {
  throw SceneError(fmt::format(
      "cannot set '{}': nodes, materials, lights and textures have no fields", key_text(L, 2)));
}

int node_text(lua_State* L) {
  const auto node = held<Node>(L, 1);
  lua_pushstring(L, fmt::format("node '{}'", node ? node->name : "").c_str());
  return 1;
}

/// Sets the bindings that `belongs` accepts as fields of the table on top of the stack.
template <class Belongs>
void set_functions(lua_State* L, Belongs belongs) {
  for (const Binding& binding : table) {
    if (belongs(binding)) {
      lua_pushlstring(L, binding.name().data(), binding.name().size());
      lua_pushlightuserdata(L, const_cast<Binding*>(&binding));
      lua_pushcclosure(L, binding.function, binding_upvalue);
      lua_rawset(L, -3);
    }
  }
}

/// Gives the table on top of the stack a hidden metatable that calls `unknown` for missing keys.
void set_unknown(lua_State* L, lua_CFunction unknown) {
  lua_newtable(L);
  lua_pushcfunction(L, unknown);
  lua_setfield(L, -2, "__index");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
}

void open_node_metatable(lua_State* L) {
  new_metatable<Node>(L);
  lua_newtable(L);
  set_functions(L, [](const Binding& b) { return b.is_method(); });
  set_unknown(L, guarded<unknown_method>);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, guarded<node_text>);
  lua_setfield(L, -2, "__tostring");
  lua_pushcfunction(L, guarded<refuse_assignment>);
  lua_setfield(L, -2, "__newindex");
  lua_pop(L, 1);
}

template <class T>
void open_plain_metatable(lua_State* L) {
  new_metatable<T>(L);
  lua_pushcfunction(L, guarded<no_method<T>>);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, guarded<refuse_assignment>);
  lua_setfield(L, -2, "__newindex");
  lua_pop(L, 1);
}

}  // namespace

std::span<const Binding> bindings() { return table; }

void open_bindings(lua_State* L) {
  lua_newtable(L);
  set_functions(L, [](const Binding& b) { return b.is_gr(); });
  set_unknown(L, guarded<unknown_function>);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &gr_table_key);
  lua_setglobal(L, "gr");

  lua_pushglobaltable(L);
  set_functions(L, [](const Binding& b) { return !b.is_gr() && !b.is_method(); });
  lua_pop(L, 1);

  open_node_metatable(L);
  open_plain_metatable<const Material>(L);
  open_plain_metatable<const Light>(L);
  open_plain_metatable<const Texture>(L);
}

}  // namespace rt::lua
