#pragma once
/// Userdata that hold a std::shared_ptr. Scripts cannot reach their metatables.
#include <lua.hpp>
#include <memory>
#include <new>
#include <utility>

#include "rt/scene/light.h"
#include "rt/scene/material.h"
#include "rt/scene/node.h"

namespace rt::lua {

/// The name of a kind of userdata: of its metatable, and in messages.
template <class T>
inline constexpr const char* handle_name = nullptr;
template <>
inline constexpr const char* handle_name<Node> = "node";
template <>
inline constexpr const char* handle_name<const Material> = "material";
template <>
inline constexpr const char* handle_name<const Light> = "light";
template <>
inline constexpr const char* handle_name<const Texture> = "texture";

/// What the value at `index` holds; null when it is anything else.
template <class T>
std::shared_ptr<T> held(lua_State* L, int index) {
  const auto* handle = static_cast<std::shared_ptr<T>*>(luaL_testudata(L, index, handle_name<T>));
  return handle == nullptr ? nullptr : *handle;
}

template <class T>
void push(lua_State* L, std::shared_ptr<T> object) {
  using Handle = std::shared_ptr<T>;
  auto* handle = new (lua_newuserdata(L, sizeof(Handle))) Handle;
  luaL_setmetatable(L, handle_name<T>);
  *handle = std::move(object);  // last: nothing can throw between this and the finaliser's duty
}

/// The finaliser. It leaves an empty handle, so that a second call does no harm.
template <class T>
int collect(lua_State* L) {
  auto* handle = static_cast<std::shared_ptr<T>*>(luaL_testudata(L, 1, handle_name<T>));
  if (handle != nullptr) {
    handle->reset();
  }
  return 0;
}

/// Makes the metatable of a kind of userdata and leaves it on the stack.
template <class T>
void new_metatable(lua_State* L) {
  luaL_newmetatable(L, handle_name<T>);
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pushcfunction(L, collect<T>);
  lua_setfield(L, -2, "__gc");
}

}  // namespace rt::lua
