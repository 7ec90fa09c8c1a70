#include "describe.h"

#include <fmt/format.h>

#include "handle.h"
#include "rt/scene/options.h"

namespace rt::lua {
namespace {

std::string describe_number(lua_State* L, int index) {
  return lua_isinteger(L, index) != 0 ? fmt::format("a number ({})", lua_tointeger(L, index))
                                      : fmt::format("a number ({:.14g})", lua_tonumber(L, index));
}

std::string describe_string(lua_State* L, int index) {
  std::size_t size = 0;
  const char* data = lua_tolstring(L, index, &size);
  return fmt::format("a string (\"{}\")", shortened({data, size}));
}

std::string describe_table(lua_State* L, int index) {
  const auto items = lua_rawlen(L, index);
  if (items > 0) {
    return fmt::format("a table with {} item{}", items, items == 1 ? "" : "s");
  }
  lua_pushvalue(L, index);
  lua_pushnil(L);
  const bool empty = lua_next(L, -2) == 0;
  lua_pop(L, empty ? 1 : 3);
  return empty ? "an empty table" : "a table with named fields";
}

std::string describe_userdata(lua_State* L, int index) {
  if (const auto node = held<Node>(L, index)) {
    return fmt::format("a node (\"{}\")", shortened(node->name));
  }
  if (held<const Material>(L, index)) {
    return "a material";
  }
  if (held<const Texture>(L, index)) {
    return "a texture";
  }
  return held<const Light>(L, index) ? "a light" : "a userdata";
}

}  // namespace

std::string describe(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNONE:
      return "nothing";
    case LUA_TNIL:
      return "nil";
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) != 0 ? "a boolean (true)" : "a boolean (false)";
    case LUA_TNUMBER:
      return describe_number(L, index);
    case LUA_TSTRING:
      return describe_string(L, index);
    case LUA_TTABLE:
      return describe_table(L, index);
    case LUA_TUSERDATA:
      return describe_userdata(L, index);
    default:
      return fmt::format("a {}", luaL_typename(L, index));
  }
}

std::string shortened(std::string_view text) {
  constexpr std::size_t head = 40;
  constexpr std::size_t tail = 15;
  std::string result(text);
  if (text.size() > head + tail) {
    result = fmt::format("{}...{}", text.substr(0, head), text.substr(text.size() - tail));
  }
  for (char& c : result) {
    c = static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? ' ' : c;
  }
  return result;
}

std::string suggestion(std::string_view given, std::span<const std::string_view> known) {
  const std::string near = nearest_name(given, known);
  return fmt::format("{} There are: {}",
                     near.empty() ? "." : fmt::format("; did you mean '{}'?", near),
                     fmt::join(known, ", "));
}

}  // namespace rt::lua
