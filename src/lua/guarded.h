#pragma once
/// The one place where C++ exceptions become Lua errors.
#include <exception>
#include <lua.hpp>
#include <type_traits>

#include "call.h"

namespace rt::lua {

/// Pushes the exception's text with script:line before it, and remembers its exit code.
void push_error(lua_State* L, const std::exception& error);

/// F as a Lua function. F takes a Call& (a binding: see bindings.cpp) or a lua_State*. Only
/// std::exception is caught: Lua's own errors are C++ exceptions too, and pass through.
template <auto F>
int guarded(lua_State* L) {
  try {
    if constexpr (std::is_invocable_v<decltype(F), Call&>) {
      Call call(L);
      const int results = F(call);
      call.warn_of_ignored();
      return results;
    } else {
      return F(L);
    }
  } catch (const std::exception& error) {
    push_error(L, error);
  }
  return lua_error(L);
}

}  // namespace rt::lua
