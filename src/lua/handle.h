#pragma once
/// Userdata that hold a std::shared_ptr. Scripts cannot reach their metatables.
#include <lua.hpp>
#include <memory>
#include <new>
#include <utility>

#include "context.h"
#include "rt/scene/light.h"
#include "rt/scene/material.h"
#include "rt/scene/node.h"

namespace rt::lua {

/// A kind of userdata: its number, and its name in messages.
struct HandleKind {
  std::size_t number;
  const char* name;
};
template <class T>
inline constexpr HandleKind handle_kind{};
template <>
inline constexpr HandleKind handle_kind<Node>{0, "node"};
template <>
inline constexpr HandleKind handle_kind<const Material>{1, "material"};
template <>
inline constexpr HandleKind handle_kind<const Light>{2, "light"};
template <>
inline constexpr HandleKind handle_kind<const Texture>{3, "texture"};

/// The handle at `index`, which lives as long as that value; null when the value is anything else.
/// It is known by its metatable's address: every call of a method asks.
template <class T>
std::shared_ptr<T>* handle(lua_State* L, int index) {
  if (lua_getmetatable(L, index) == 0) {
    return nullptr;
  }
  const bool same = lua_topointer(L, -1) == context(L).metatables[handle_kind<T>.number];
  lua_pop(L, 1);
  return same ? static_cast<std::shared_ptr<T>*>(lua_touserdata(L, index)) : nullptr;
}

/// What the value at `index` holds; null when it is anything else.
template <class T>
std::shared_ptr<T> held(lua_State* L, int index) {
  const auto* const found = handle<T>(L, index);
  return found == nullptr ? nullptr : *found;
}

template <class T>
void push(lua_State* L, std::shared_ptr<T> object) {
  using Handle = std::shared_ptr<T>;
  auto* handle = new (lua_newuserdata(L, sizeof(Handle))) Handle;
  lua_rawgetp(L, LUA_REGISTRYINDEX, &handle_kind<T>);
  lua_setmetatable(L, -2);
  *handle = std::move(object);  // last: nothing can throw between this and the finaliser's duty
}

/// The finaliser. It leaves an empty handle, so that a second call does no harm.
template <class T>
int collect(lua_State* L) {
  if (auto* const found = handle<T>(L, 1)) {
    found->reset();
  }
  return 0;
}

/// Makes the metatable of a kind of userdata and leaves it on the stack.
template <class T>
void new_metatable(lua_State* L) {
  lua_newtable(L);
  context(L).metatables[handle_kind<T>.number] = lua_topointer(L, -1);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &handle_kind<T>);
  lua_pushstring(L, handle_kind<T>.name);
  lua_setfield(L, -2, "__name");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pushcfunction(L, collect<T>);
  lua_setfield(L, -2, "__gc");
}

}  // namespace rt::lua
