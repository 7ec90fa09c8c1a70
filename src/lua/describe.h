#pragma once
/// Words for values and names in messages.
#include <lua.hpp>
#include <span>
#include <string>
#include <string_view>

namespace rt::lua {

/// The value at `index` in words: "a number (3)", "a string ("red")", "a node ("ball")".
std::string describe(lua_State* L, int index);

/// The text on one line, its middle left out when it is long.
std::string shortened(std::string_view text);

/// "; did you mean 'b'? There are: a, b, c" for a name that is none of `known`.
std::string suggestion(std::string_view given, std::span<const std::string_view> known);

}  // namespace rt::lua
