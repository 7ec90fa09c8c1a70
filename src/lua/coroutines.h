#pragma once
#include <lua.hpp>

namespace rt::lua {

/// Replaces create, resume and wrap of Lua's library `coroutine` by functions that do the same and
/// tell the guard which coroutine runs.
void open_coroutines(lua_State* L);

}  // namespace rt::lua
