#include "coroutines.h"

#include "context.h"

namespace rt::lua {
namespace {

/// Runs `co` with the arguments on top of L's stack. Returns how many results it left on L's stack,
/// or -1 with an error there.
int run(lua_State* L, lua_State* co, int arguments) {
  if (lua_checkstack(co, arguments) == 0) {
    lua_pushliteral(L, "too many arguments to resume");
    return -1;
  }
  if (lua_status(co) == LUA_OK && lua_gettop(co) == 0) {
    lua_pushliteral(L, "cannot resume dead coroutine");
    return -1;
  }
  lua_xmove(L, co, arguments);
  Guard& guard = context(L).guard;
  guard.switch_to(co);
  const int status = lua_resume(co, L, arguments);
  guard.switch_to(L);
  if (status != LUA_OK && status != LUA_YIELD) {
    lua_xmove(co, L, 1);
    return -1;
  }
  const int results = lua_gettop(co);
  if (lua_checkstack(L, results + 1) == 0) {
    lua_pop(co, results);
    lua_pushliteral(L, "too many results to resume");
    return -1;
  }
  lua_xmove(co, L, results);
  return results;
}

int create(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_State* co = lua_newthread(L);
  lua_pushvalue(L, 1);
  lua_xmove(L, co, 1);
  context(L).guard.count_new_coroutine(L);
  return 1;
}

int resume(lua_State* L) {
  lua_State* co = lua_tothread(L, 1);
  luaL_argcheck(L, co != nullptr, 1, "coroutine expected");
  const int results = run(L, co, lua_gettop(L) - 1);
  lua_pushboolean(L, results >= 0 ? 1 : 0);
  lua_insert(L, -(results >= 0 ? results + 1 : 2));
  return results >= 0 ? results + 1 : 2;
}

int call_wrapped(lua_State* L) {
  lua_State* co = lua_tothread(L, lua_upvalueindex(1));
  const int results = run(L, co, lua_gettop(L));
  if (results >= 0) {
    return results;
  }
  if (lua_type(L, -1) == LUA_TSTRING) {
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
  }
  return lua_error(L);
}

int wrap(lua_State* L) {
  create(L);
  lua_pushcclosure(L, call_wrapped, 1);
  return 1;
}

}  // namespace

void open_coroutines(lua_State* L) {
  lua_getglobal(L, LUA_COLIBNAME);
  constexpr luaL_Reg functions[] = {
      {"create", create}, {"resume", resume}, {"wrap", wrap}, {nullptr, nullptr}};
  luaL_setfuncs(L, functions, 0);
  lua_pop(L, 1);
}

}  // namespace rt::lua
