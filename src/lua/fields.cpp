#include "fields.h"

#include <fmt/format.h>

#include <algorithm>

#include "describe.h"

namespace rt::lua {
namespace {

void push_raw(lua_State* L, int index, std::string_view name) {
  lua_pushlstring(L, name.data(), name.size());
  lua_rawget(L, index);
}

}  // namespace

void push_field(const Call& call, int index, std::string_view name, std::string_view alias) {
  lua_State* L = call.L;
  luaL_checkstack(L, 4, nullptr);
  push_raw(L, index, name);
  if (alias.empty()) {
    return;
  }
  push_raw(L, index, alias);
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
    return;
  }
  if (!lua_isnil(L, -2)) {
    call.fail(fmt::format("both '{}' and '{}' are given; give one", name, alias));
  }
  lua_remove(L, -2);
}

std::vector<std::string> other_keys(lua_State* L, int index,
                                    std::span<const std::string_view> known) {
  std::vector<std::string> keys;
  luaL_checkstack(L, 4, nullptr);
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    lua_pop(L, 1);
    if (lua_type(L, -1) != LUA_TSTRING) {
      keys.push_back(lua_isinteger(L, -1) != 0 ? fmt::format("[{}]", lua_tointeger(L, -1))
                                               : fmt::format("[{}]", describe(L, -1)));
      continue;
    }
    std::size_t size = 0;
    const char* data = lua_tolstring(L, -1, &size);
    if (std::ranges::find(known, std::string_view(data, size)) == known.end()) {
      keys.emplace_back(data, size);
    }
  }
  std::ranges::sort(keys);
  return keys;
}

void refuse_keys(const Call& call, std::string_view table, std::span<const std::string> keys,
                 std::span<const std::string_view> known) {
  if (keys.empty()) {
    return;
  }
  if (call.run().settings.lenient) {
    for (const std::string& key : keys) {
      warn_once(call.L, call.title() + " key " + key,
                fmt::format("{}: unknown key '{}' is ignored", call.title(), shortened(key)));
    }
  } else {
    call.fail(fmt::format("unknown key '{}'{}{}{}", shortened(keys.front()),
                          table.empty() ? "" : " in ", table, suggestion(keys.front(), known)));
  }
}

}  // namespace rt::lua
