#include "value.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "call.h"
#include "describe.h"

namespace rt::lua {

lua_State* Value::state() const { return call_.L; }

int Value::type() const { return index_ == 0 ? LUA_TNONE : lua_type(state(), index_); }

bool Value::is_list() const {
  if (type() != LUA_TTABLE) {
    return false;
  }
  const bool found = lua_rawgeti(state(), index_, 1) != LUA_TNIL;
  lua_pop(state(), 1);
  return found;
}

double Value::number(const Range& range) const {
  if (type() != LUA_TNUMBER) {
    fail(range.words);
  }
  const double value = lua_tonumber(state(), index_);
  if (!std::isfinite(value)) {
    fail("a finite number");
  }
  if (value < range.lo || value > range.hi) {
    fail(range.words);
  }
  return value;
}

int Value::whole(int lo, int hi, std::string_view expected) const {
  if (type() != LUA_TNUMBER) {
    fail(expected);
  }
  const double value = lua_tonumber(state(), index_);
  if (!(value >= lo && value <= hi) || value != std::floor(value)) {
    fail(expected);
  }
  return static_cast<int>(value);
}

bool Value::boolean() const {
  if (type() != LUA_TBOOLEAN) {
    fail("true or false");
  }
  return lua_toboolean(state(), index_) != 0;
}

std::string Value::text(std::string_view expected) const {
  if (type() != LUA_TSTRING) {
    fail(expected);
  }
  std::size_t size = 0;
  const char* data = lua_tolstring(state(), index_, &size);
  return {data, size};
}

int Value::axis(std::string_view expected) const {
  const std::string letter = text(expected);
  const int axis =
      letter.size() == 1 ? std::tolower(static_cast<unsigned char>(letter[0])) - 'x' : -1;
  if (axis < 0 || axis > 2) {
    fail(expected);
  }
  return axis;
}

Vec3 Value::triple(const Range& range, std::string_view expected) const {
  if (type() != LUA_TTABLE) {
    fail(expected);
  }
  lua_State* L = state();
  Vec3 result{0.0};
  for (int i = 0; i < 3; ++i) {
    lua_rawgeti(L, index_, i + 1);
    const double value = lua_tonumber(L, -1);
    if (lua_type(L, -1) != LUA_TNUMBER || !std::isfinite(value) || value < range.lo ||
        value > range.hi) {
      fail(expected, fmt::format("a table whose item {} is {}", i + 1, describe(L, -1)));
    }
    result[i] = value;
    lua_pop(L, 1);
  }
  if (lua_rawlen(L, index_) != 3) {
    fail(expected);
  }
  return result;
}

Rgb Value::colour() const {
  return triple_or_number(not_negative, "a colour {r, g, b}, not negative");
}

Vec3 Value::triple_or_number(const Range& range, std::string_view expected) const {
  return type() == LUA_TNUMBER ? Vec3(number({expected, range.lo, range.hi}))
                               : triple(range, expected);
}

template <class T>
std::shared_ptr<T> Value::object() const {
  std::shared_ptr<T> result = index_ == 0 ? nullptr : held<T>(state(), index_);
  if (!result) {
    fail(fmt::format("a {}", handle_kind<T>.name));
  }
  return result;
}
template std::shared_ptr<Node> Value::object() const;
template std::shared_ptr<const Material> Value::object() const;
template std::shared_ptr<const Light> Value::object() const;
template std::shared_ptr<const Texture> Value::object() const;

void Value::fail(std::string_view expected, std::string_view given) const {
  std::string place;
  if (argument_ > 0) {
    place = fmt::format("argument {}", argument_);
    if (!name_.empty()) {
      place += fmt::format(" ({})", name_);
    }
  } else {
    place = fmt::format("'{}{}{}'", table_, table_.empty() ? "" : ".", name_);
  }
  const std::string got(!given.empty() ? given
                        : index_ == 0  ? "nothing"
                                       : describe(state(), index_));
  // `parent.add_child(child)` gives the method its child as the node and no argument.
  const bool lost_colon = call_.binding.is_method() && type() == LUA_TNONE;
  call_.fail(fmt::format("expected {} as {}, got {}; try {}{}", expected, place, got,
                         call_.binding.example, lost_colon ? " (with a colon)" : ""));
}

}  // namespace rt::lua
