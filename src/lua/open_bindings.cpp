/// How the table of bindings gets into a Lua state, and what a script is told that reaches past it.
#include <fmt/format.h>

#include <vector>

#include "binding.h"
#include "describe.h"
#include "guarded.h"
#include "handle.h"
#include "nodes.h"

namespace rt::lua {
namespace {

/// The names that begin with `prefix`, without it.
std::vector<std::string_view> names_in(std::string_view prefix) {
  std::vector<std::string_view> names;
  for (const Binding& binding : bindings()) {
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
  for (const Binding& binding : bindings()) {
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
