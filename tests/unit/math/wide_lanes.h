#pragma once
/// Arguments for functions of several lanes, and comparison with what each lane's scalar function
/// gives: the same bits, but for the sign of zeros.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "rt/math/wide.h"

namespace rt::test {

inline bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }
inline bool same(const Vec2& a, const Vec2& b) { return same(a.x, b.x) && same(a.y, b.y); }
inline bool same(const Vec3& a, const Vec3& b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// Random arguments, of which a good part are edges: what the lanes of one packet hold differs.
class Arguments {
 public:
  explicit Arguments(unsigned seed) : engine_(seed) {}

  double uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  double pick(const std::vector<double>& edges, double lo, double hi) {
    return engine_() % 3 == 0 ? edges[engine_() % edges.size()] : uniform(lo, hi);
  }
  /// In the unit square; its centre, sides, diagonals and the cells next to them among them.
  Vec2 square() {
    static const std::vector<double> edges{0.5, 0x1p-33, 1 - 0x1p-33, 0.5 - 0x1p-33, 0.5 + 0x1p-33};
    const double x = pick(edges, 0, 1);
    const std::uint64_t which = engine_() % 4;
    return {x, which == 0 ? x : which == 1 ? 1 - x : pick(edges, 0, 1)};
  }
  Vec3 direction() {
    const Vec3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    return glm::normalize(v);
  }
  /// Any unit vector, or one along an axis.
  Vec3 direction_or_axis() {
    if (engine_() % 4 != 0) {
      return direction();
    }
    Vec3 v(0.0);
    v[static_cast<int>(engine_() % 3)] = engine_() % 2 == 0 ? 1.0 : -1.0;
    return v;
  }
  std::uint64_t bits() { return engine_(); }

 private:
  std::mt19937_64 engine_;
};

template <class T>
using Lanes = std::array<T, lanes>;

/// One argument a lane.
template <class Draw>
auto drawn(Draw draw) {
  Lanes<decltype(draw())> out;
  for (auto& one : out) {
    one = draw();
  }
  return out;
}

inline Wide packed(const Lanes<double>& v) {
  return Wide([&](auto i) { return v[i]; });
}
inline Wide2 packed(const Lanes<Vec2>& v) {
  return {Wide([&](auto i) { return v[i].x; }), Wide([&](auto i) { return v[i].y; })};
}
inline Wide3 packed(const Lanes<Vec3>& v) {
  return {Wide([&](auto i) { return v[i].x; }), Wide([&](auto i) { return v[i].y; }),
          Wide([&](auto i) { return v[i].z; })};
}

}  // namespace rt::test
