#include "libraries.h"

#include <array>

namespace rt::lua {
namespace {

/// load(chunk, name, mode, env), mode "t" whatever is asked for: bytecode can crash Lua. The
/// library's own function is the upvalue.
int load_text_only(lua_State* L) {
  if (lua_gettop(L) < 3) {
    lua_settop(L, 3);  // not 4: an environment of nil is not the same as none
  }
  lua_pushliteral(L, "t");
  lua_replace(L, 3);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

void remove(lua_State* L, const char* name) {
  lua_pushnil(L);
  lua_setfield(L, -2, name);
}

}  // namespace

void open_libraries(lua_State* L) {
  constexpr std::array<luaL_Reg, 6> libraries{{{"_G", luaopen_base},
                                               {LUA_TABLIBNAME, luaopen_table},
                                               {LUA_STRLIBNAME, luaopen_string},
                                               {LUA_MATHLIBNAME, luaopen_math},
                                               {LUA_UTF8LIBNAME, luaopen_utf8},
                                               {LUA_COLIBNAME, luaopen_coroutine}}};
  for (const luaL_Reg& library : libraries) {
    luaL_requiref(L, library.name, library.func, 1);
    lua_pop(L, 1);
  }

  lua_pushglobaltable(L);
  remove(L, "dofile");
  remove(L, "loadfile");
  lua_getfield(L, -1, "load");
  lua_pushcclosure(L, load_text_only, 1);
  lua_setfield(L, -2, "load");
  lua_getfield(L, -1, LUA_STRLIBNAME);
  remove(L, "dump");
  lua_pop(L, 2);

  lua_newtable(L);
  lua_pushcfunction(L, luaopen_os);
  lua_call(L, 0, 1);
  for (const char* name : {"time", "clock", "date", "difftime"}) {
    lua_getfield(L, -1, name);
    lua_setfield(L, -3, name);
  }
  lua_pop(L, 1);
  lua_setglobal(L, LUA_OSLIBNAME);
}

}  // namespace rt::lua
