#pragma once
#include <lua.hpp>

namespace rt::lua {

/// Adds what Lua 5.1 had and 5.3 has not, for scripts of that time: unpack, loadstring, module with
/// package.seeall, table.getn, maxn, foreach and foreachi, string.gfind, math.mod and math.pow.
/// Each but seeall warns when it is first called and names what to write instead.
void open_compat(lua_State* L);

}  // namespace rt::lua
