#pragma once
/// Typed readers for the values that a script gives. Each throws SceneError saying what was
/// expected, what was given, and what to try.
#include <limits>
#include <lua.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "handle.h"
#include "rt/math/vec.h"

namespace rt::lua {

class Call;

/// Which numbers are allowed, and what messages call them. Only finite ones are, ever.
struct Range {
  std::string_view words;
  double lo = std::numeric_limits<double>::lowest();
  double hi = std::numeric_limits<double>::max();
};
inline constexpr Range any_number{"a number"};
inline constexpr Range positive{"a positive number", std::numeric_limits<double>::denorm_min()};
inline constexpr Range not_negative{"a number that is not negative", 0.0};
inline constexpr Range fraction{"a number from 0 to 1", 0.0, 1.0};

/// A value on the stack, and its place in the call: an argument, or a field of a table.
class Value {
 public:
  /// Argument `argument`; `index` is 0 when it is absent.
  Value(const Call& call, int index, int argument, std::string_view name)
      : call_(call), index_(index), argument_(argument), name_(name) {}
  /// The field `name` of the table that messages call `table` (empty: the argument itself).
  Value(const Call& call, int index, std::string_view table, std::string_view name)
      : call_(call), index_(index), name_(name), table_(table) {}

  const Call& call() const { return call_; }
  int index() const { return index_; }
  std::string_view name() const { return name_; }
  /// False when absent or nil.
  bool given() const { return type() > LUA_TNIL; }
  /// LUA_TNUMBER, ...; LUA_TNONE when absent.
  int type() const;
  /// A table that has an item 1.
  bool is_list() const;

  double number(const Range& range = any_number) const;
  /// A whole number; 640 and 640.0 alike.
  int whole(int lo, int hi, std::string_view expected) const;
  bool boolean() const;
  std::string text(std::string_view expected) const;
  /// 0, 1 or 2 for 'x', 'y' or 'z', small or capital.
  int axis(std::string_view expected) const;
  /// {x, y, z}.
  Vec3 triple(const Range& range = any_number,
              std::string_view expected = "three numbers {x, y, z}") const;
  /// {r, g, b} or one number for a grey; not negative.
  Rgb colour() const;
  /// Three numbers {x, y, z}, or one for all three.
  Vec3 triple_or_number(const Range& range, std::string_view expected) const;
  /// A node, a material, a light.
  template <class T>
  std::shared_ptr<T> object() const;

  /// Throws SceneError: "expected ... as argument 1, got ...; try ...". `given` describes the value
  /// unless it is said.
  [[noreturn]] void fail(std::string_view expected, std::string_view given = {}) const;

 private:
  const Call& call_;
  int index_;
  int argument_ = 0;
  std::string_view name_;
  std::string_view table_;

  lua_State* state() const;
};

}  // namespace rt::lua
