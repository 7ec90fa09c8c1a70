/// node:motion.
#include <algorithm>

#include "context.h"
#include "fields.h"
#include "functions.h"
#include "rt/scene/motion.h"

namespace rt::lua {
namespace {

constexpr std::string_view rotation_words = "{axis, degrees}, the axis 'x', 'y', 'z' or {x, y, z}";

Vec3 axis_of(const Value& value) {
  if (value.type() == LUA_TTABLE) {
    const Vec3 axis = value.triple();
    if (axis == Vec3(0.0)) {
      value.fail("an axis that is not {0, 0, 0}");
    }
    return axis;
  }
  Vec3 axis(0.0);
  axis[value.axis(rotation_words)] = 1.0;
  return axis;
}

void read_rotation(const Value& value, Pose& pose) {
  lua_State* L = value.call().L;
  if (value.type() != LUA_TTABLE || lua_rawlen(L, value.index()) != 2) {
    value.fail(rotation_words);
  }
  lua_rawgeti(L, value.index(), 1);
  pose.axis = axis_of(Value(value.call(), lua_gettop(L), "rotate", "axis"));
  lua_rawgeti(L, value.index(), 2);
  pose.degrees = Value(value.call(), lua_gettop(L), "rotate", "degrees").number();
  lua_pop(L, 2);
}

void read_scale(const Value& value, Pose& pose) {
  pose.scale = value.triple_or_number(any_number, "a number or three {x, y, z}");
  if (pose.scale.x == 0.0 || pose.scale.y == 0.0 || pose.scale.z == 0.0) {
    value.fail("factors that are not 0");
  }
}

Pose read_pose(const Value& value, std::string_view table) {
  static constexpr std::array fields{
      Field<Pose>{"translate", [](const Value& v, Pose& p) { p.translate = v.triple(); }},
      Field<Pose>{"rotate", read_rotation},
      Field<Pose>{"scale", read_scale},
      Field<Pose>{"about", [](const Value& v, Pose& p) { p.about = v.triple(); }},
  };
  if (value.type() != LUA_TTABLE) {
    value.fail("a table {translate =, rotate =, scale =, about =}");
  }
  Pose pose;
  read_only_fields<Pose>(value.call(), value.index(), table, fields, pose);
  return pose;
}

struct Ends {
  Pose from, to;
};

Motion motion_between(const Call& call, int index) {
  static constexpr std::array fields{
      Field<Ends>{"from", [](const Value& v, Ends& e) { e.from = read_pose(v, "from"); }},
      Field<Ends>{"to", [](const Value& v, Ends& e) { e.to = read_pose(v, "to"); }, "", true},
  };
  Ends ends;
  read_only_fields<Ends>(call, index, "", fields, ends);
  return {{{0.0, ends.from}, {1.0, ends.to}}};
}

/// Keys of the movement that a script's function describes, called as often as it takes for
/// straight lines between keys to follow it.
class Sampled {
 public:
  Sampled(const Call& call, int function) : call_(call), function_(function) {}

  Motion take() {
    // Some at first, so that a full turn does not look still.
    constexpr int first = 8;
    for (int i = 0; i <= first; ++i) {
      const double time = i / double{first};
      motion_.keys.push_back({time, pose_at(time)});
    }
    for (int level = 0; level < levels && divide(); ++level) {
    }
    return std::move(motion_);
  }

 private:
  static constexpr int levels = 9;           ///< 4096 intervals at most
  static constexpr double tolerance = 1e-4;  ///< relative to how far each number ranges

  Pose pose_at(double time) const {
    lua_State* L = call_.L;
    luaL_checkstack(L, 8, nullptr);
    lua_pushvalue(L, function_);
    lua_pushnumber(L, time);
    lua_call(L, 1, 1);
    const Pose pose = read_pose(Value(call_, lua_gettop(L), "", "the function's result"), "");
    lua_pop(L, 1);
    return pose;
  }

  static std::array<Vec3, 5> numbers(const Pose& p) {
    return {p.translate, p.axis, Vec3(p.degrees), p.scale, p.about};
  }

  /// The largest change of each kind of number over the keys so far.
  std::array<double, 5> ranges() const {
    std::array<double, 5> r{};
    const auto start = numbers(motion_.keys.front().pose);
    for (const MotionKey& key : motion_.keys) {
      const auto now = numbers(key.pose);
      for (std::size_t k = 0; k < r.size(); ++k) {
        r[k] = std::max(r[k], max_abs(now[k] - start[k]));
      }
    }
    return r;
  }

  /// Puts a key between every two whose mean is not what the function says. False: there were none.
  bool divide() {
    const auto range = ranges();
    std::vector<MotionKey> finer{motion_.keys.front()};
    bool divided = false;
    for (std::size_t i = 0; i + 1 < motion_.keys.size(); ++i) {
      const MotionKey& a = motion_.keys[i];
      const MotionKey& b = motion_.keys[i + 1];
      const double middle = 0.5 * (a.time + b.time);
      const Pose truth = pose_at(middle);
      const auto expected = numbers(between(a.pose, b.pose, 0.5));
      const auto given = numbers(truth);
      bool off = false;
      for (std::size_t k = 0; k < range.size(); ++k) {
        off = off || max_abs(expected[k] - given[k]) > tolerance * range[k];
      }
      if (off) {
        finer.push_back({middle, truth});
        divided = true;
      }
      finer.push_back(b);
    }
    motion_.keys = std::move(finer);
    return divided;
  }

  const Call& call_;
  int function_;
  Motion motion_;
};

}  // namespace

int node_motion(Call& call) {
  const Value value = call.argument(1, "motion");
  Motion motion;
  if (value.type() == LUA_TFUNCTION) {
    motion = Sampled(call, value.index()).take();
  } else if (value.type() == LUA_TTABLE) {
    motion = motion_between(call, value.index());
  } else {
    value.fail("a table {from =, to =} or a function of the time");
  }
  const std::size_t keys = motion.keys.capacity() * sizeof(MotionKey);
  call.self()->motion = make_charged(call.L, std::move(motion), keys);
  return call.return_self();
}

}  // namespace rt::lua
