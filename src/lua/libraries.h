#pragma once
#include <lua.hpp>

namespace rt::lua {

/// Opens what scripts may have of Lua's own libraries: base without dofile and loadfile, and with a
/// `load` that takes text only; table, string without dump, math, utf8, coroutine; and of os the
/// functions time, clock, date and difftime. Neither io, debug nor package.
void open_libraries(lua_State* L);

}  // namespace rt::lua
