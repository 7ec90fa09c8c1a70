#include "compat.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "context.h"
#include "guarded.h"

namespace rt::lua {
namespace {

/// Upvalues of each: its old name, what to write instead, and the function that does it.
constexpr int old_name = 1;
constexpr int new_name = 2;
constexpr int function = 3;

void warn_of_old(lua_State* L) {
  const char* was = lua_tostring(L, lua_upvalueindex(old_name));
  const char* is = lua_tostring(L, lua_upvalueindex(new_name));
  warn_once(L, was, fmt::format("{} is of Lua 5.1 and served for now; write {}", was, is));
}

int call_successor(lua_State* L) {
  warn_of_old(L);
  lua_pushvalue(L, lua_upvalueindex(function));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

int table_length(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_pushinteger(L, luaL_len(L, 1));
  return 1;
}

int table_maxn(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_Number most = 0;
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) == LUA_TNUMBER) {
      most = std::max(most, lua_tonumber(L, -2));
    }
  }
  lua_pushnumber(L, most);
  return 1;
}

/// table.foreach(t, f): f(key, value) until it returns something.
int table_foreach(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_checktype(L, 2, LUA_TFUNCTION);
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 2)) {
    lua_pushvalue(L, 2);
    lua_pushvalue(L, -3);
    lua_pushvalue(L, -3);
    lua_call(L, 2, 1);
    if (!lua_isnil(L, -1)) {
      return 1;
    }
  }
  return 0;
}

int table_foreachi(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_checktype(L, 2, LUA_TFUNCTION);
  const lua_Integer size = luaL_len(L, 1);
  for (lua_Integer i = 1; i <= size; ++i) {
    lua_pushvalue(L, 2);
    lua_pushinteger(L, i);
    lua_geti(L, 1, i);
    lua_call(L, 2, 1);
    if (!lua_isnil(L, -1)) {
      return 1;
    }
    lua_pop(L, 1);
  }
  return 0;
}

/// module(name, ...): the globals of the chunk that calls it are from here on those of a table of
/// that name, which `require` returns. With package.seeall it sees the real ones.
int module(lua_State* L) {
  const char* name = luaL_checkstring(L, 1);
  lua_settop(L, lua_gettop(L) > 1 ? 2 : 1);
  lua_pushglobaltable(L);
  lua_newtable(L);
  lua_pushstring(L, name);
  lua_setfield(L, -2, "_NAME");
  lua_pushvalue(L, -1);
  lua_setfield(L, -2, "_M");
  if (lua_isfunction(L, 2)) {
    lua_newtable(L);
    lua_pushvalue(L, -3);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, -2);
  }
  lua_pushvalue(L, -1);
  lua_setfield(L, -3, name);
  lua_getfield(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_pushvalue(L, -2);
  lua_setfield(L, -2, name);  // what require returns
  lua_pop(L, 1);

  lua_Debug caller;
  if (lua_getstack(L, 2, &caller) == 0 || lua_getinfo(L, "f", &caller) == 0) {
    return luaL_error(L, "module: must be called by a chunk");
  }
  lua_insert(L, -2);  // the chunk below its new globals
  const char* upvalue = lua_iscfunction(L, -2) != 0 ? nullptr : lua_getupvalue(L, -2, 1);
  if (upvalue == nullptr || std::string_view(upvalue) != "_ENV") {
    return luaL_error(L, "module: must be called by a chunk that uses globals");
  }
  lua_pop(L, 1);
  lua_setupvalue(L, -2, 1);
  return 0;
}

/// What module is told by package.seeall.
int see_all(lua_State*) { return 0; }

struct Old {
  const char* table;  ///< null: a global
  const char* name;
  const char* instead;
  const char* successor_table;  ///< null: `function` does it
  const char* successor;
  lua_CFunction function;
};

constexpr Old olds[] = {
    {nullptr, "unpack", "table.unpack", LUA_TABLIBNAME, "unpack", nullptr},
    {nullptr, "loadstring", "load", "_G", "load", nullptr},
    {nullptr, "module", "a table that the file returns", nullptr, nullptr, module},
    {LUA_TABLIBNAME, "getn", "#list", nullptr, nullptr, table_length},
    {LUA_TABLIBNAME, "maxn", "#list", nullptr, nullptr, table_maxn},
    {LUA_TABLIBNAME, "foreach", "for k, v in pairs(t)", nullptr, nullptr, table_foreach},
    {LUA_TABLIBNAME, "foreachi", "for i, v in ipairs(t)", nullptr, nullptr, table_foreachi},
    {LUA_STRLIBNAME, "gfind", "string.gmatch", LUA_STRLIBNAME, "gmatch", nullptr},
    {LUA_MATHLIBNAME, "mod", "math.fmod", LUA_MATHLIBNAME, "fmod", nullptr},
    {LUA_MATHLIBNAME, "pow", "x ^ y", LUA_MATHLIBNAME, "pow", nullptr},
};

}  // namespace

void open_compat(lua_State* L) {
  lua_pushglobaltable(L);
  for (const Old& old : olds) {
    lua_getfield(L, -1, old.table == nullptr ? "_G" : old.table);
    const std::string name =
        old.table == nullptr ? old.name : fmt::format("{}.{}", old.table, old.name);
    lua_pushstring(L, name.c_str());
    lua_pushstring(L, old.instead);
    if (old.function != nullptr) {
      lua_pushcfunction(L, old.function);
    } else {
      lua_getfield(L, -4, old.successor_table);
      lua_getfield(L, -1, old.successor);
      lua_remove(L, -2);
    }
    lua_pushcclosure(L, guarded<call_successor>, 3);
    lua_setfield(L, -2, old.name);
    lua_pop(L, 1);
  }
  if (lua_getfield(L, -1, LUA_LOADLIBNAME) == LUA_TNIL) {
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, -4, LUA_LOADLIBNAME);
    lua_replace(L, -2);
  }
  lua_pushcfunction(L, see_all);
  lua_setfield(L, -2, "seeall");
  lua_pop(L, 2);
}

}  // namespace rt::lua
