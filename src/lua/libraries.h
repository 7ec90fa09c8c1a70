#pragma once
#include <lua.hpp>

namespace rt::lua {

/// Opens what scripts may have of Lua's own libraries: base without dofile and loadfile, with a
/// `load` that takes text only and a setmetatable that refuses finalisers; table, string without
/// dump, math, utf8, coroutine; and of os the functions time, clock, date and difftime. Neither io,
/// debug nor package.
void open_libraries(lua_State* L);

/// Opens all of them, for a script that is trusted. `require` and `dofile` stay those of the
/// bindings, which replace Lua's.
void open_all_libraries(lua_State* L);

}  // namespace rt::lua
