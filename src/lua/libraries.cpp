#include "libraries.h"

#include <array>

#include "context.h"
#include "coroutines.h"

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

/// setmetatable without __gc: Lua runs finalisers with hooks off, where no limit but the watchdog's
/// would hold. Otherwise the library's, written out in as few calls as will do: scripts with
/// classes call it for every object. The string "__gc" is the upvalue.
int setmetatable_without_gc(lua_State* L) {
  if (lua_type(L, 1) != LUA_TTABLE) {
    luaL_checktype(L, 1, LUA_TTABLE);
  }
  const int type = lua_type(L, 2);
  if (type == LUA_TTABLE) {
    lua_pushvalue(L, lua_upvalueindex(1));
    if (lua_rawget(L, 2) != LUA_TNIL) {
      return luaL_error(L, "setmetatable: scripts have no finalisers; leave __gc out");
    }
  } else {
    luaL_argcheck(L, type == LUA_TNIL, 2, "nil or table expected");
  }
  if (lua_getmetatable(L, 1) != 0) {
    if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL) {
      return luaL_error(L, "cannot change a protected metatable");
    }
  }
  lua_settop(L, 2);
  lua_setmetatable(L, 1);
  return 1;
}

/// A message handler of the script's, the upvalue, unless the script has been stopped: the error of
/// a stop is raised by a hook, and until it is caught Lua runs with hooks off.
int handle_message(lua_State* L) {
  if (!context(L).guard.stopped()) {
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, 1);
  }
  return 1;
}

int all_results(lua_State* L, int, lua_KContext) { return lua_gettop(L); }

/// xpcall(f, handler, ...) with the handler guarded. The library's own function is the upvalue.
int guarded_xpcall(lua_State* L) {
  if (lua_isfunction(L, 2)) {
    lua_pushvalue(L, 2);
    lua_pushcclosure(L, handle_message, 1);
    lua_replace(L, 2);
  }
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_callk(L, lua_gettop(L) - 1, LUA_MULTRET, 0, all_results);
  return lua_gettop(L);
}

/// Replaces the global function by `wrapper`, which gets it as its upvalue.
void wrap_global(lua_State* L, const char* name, lua_CFunction wrapper) {
  lua_getglobal(L, name);
  lua_pushcclosure(L, wrapper, 1);
  lua_setglobal(L, name);
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
  wrap_global(L, "load", load_text_only);
  lua_pushliteral(L, "__gc");
  lua_pushcclosure(L, setmetatable_without_gc, 1);
  lua_setglobal(L, "setmetatable");
  wrap_global(L, "xpcall", guarded_xpcall);
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
  open_coroutines(L);
}

void open_all_libraries(lua_State* L) {
  luaL_openlibs(L);
  open_coroutines(L);
}

}  // namespace rt::lua
