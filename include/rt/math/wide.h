#pragma once
/// Several doubles at a time: as many as a vector register of the machine compiled for holds. Every
/// lane goes through the operations that its scalar counterpart would, in the same order, each
/// rounded once; so a lane's bits depend neither on the number of lanes nor on the others'
/// contents.
#include <experimental/simd>
#include <limits>

#include "rt/math/transform.h"
#include "rt/math/vec.h"

namespace rt {

namespace stdx = std::experimental;

using Wide = stdx::native_simd<double>;
using WideMask = Wide::mask_type;

inline constexpr int lanes = static_cast<int>(Wide::size());
inline constexpr unsigned all_lanes = (1U << lanes) - 1U;

/// Lane i as bit i.
inline unsigned bits_of(const WideMask& m) {
  return static_cast<unsigned>(m.__to_bitset().to_ulong());
}
inline WideMask mask_of(unsigned bits) {
  return WideMask::__from_bitset(std::bitset<Wide::size()>(bits));
}
inline bool any(const WideMask& m) { return stdx::any_of(m); }

/// a where the mask is set, else b.
inline Wide select(const WideMask& m, const Wide& a, const Wide& b) {
  Wide r = b;
  stdx::where(m, r) = a;
  return r;
}

inline Wide sqrt(const Wide& a) { return stdx::sqrt(a); }
inline Wide fma(const Wide& a, const Wide& b, const Wide& c) { return stdx::fma(a, b, c); }
inline Wide abs(const Wide& a) { return stdx::abs(a); }
inline Wide floor(const Wide& a) { return stdx::floor(a); }
inline Wide copysign(const Wide& a, const Wide& b) { return stdx::copysign(a, b); }
/// As std::max and std::min: the first where the two compare equal or one is NaN.
inline Wide max(const Wide& a, const Wide& b) { return select(a < b, b, a); }
inline Wide min(const Wide& a, const Wide& b) { return select(b < a, b, a); }

/// Calls visit(lane) for every bit that is set.
template <class Visit>
void each_lane(unsigned bits, Visit&& visit) {
  for (; bits != 0; bits &= bits - 1) {
    visit(std::countr_zero(bits));
  }
}

/// Copied number by number, and so whatever holds one: as a whole GCC copies vectors by halves, and a
/// load of the whole then waits for both. (Its options -mmove-max and -mstore-max, which would cure
/// that, make GCC 12 initialise structures of constants wrongly.)
struct Wide2 {
  Wide x, y;

  Wide2() = default;
  Wide2(const Wide& a, const Wide& b) : x(a), y(b) {}
  Wide2(const Wide2& b) : x(b.x), y(b.y) {}
  Wide2& operator=(const Wide2& b) {
    x = b.x;
    y = b.y;
    return *this;
  }

  Vec2 lane(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return {x[at], y[at]};
  }
};

/// Points, directions or colours, one a lane. Operations as GLM's, in GLM's order.
struct Wide3 {
  Wide x, y, z;

  Wide3() = default;
  Wide3(const Wide3& b) : x(b.x), y(b.y), z(b.z) {}
  Wide3& operator=(const Wide3& b) {
    x = b.x;
    y = b.y;
    z = b.z;
    return *this;
  }
  Wide3(const Wide& a, const Wide& b, const Wide& c) : x(a), y(b), z(c) {}
  explicit Wide3(const Wide& a) : x(a), y(a), z(a) {}
  /// The same in every lane.
  Wide3(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}

  Vec3 lane(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return {x[at], y[at], z[at]};
  }
  void set(int i, const Vec3& v) {
    const auto at = static_cast<std::size_t>(i);
    x[at] = v.x;
    y[at] = v.y;
    z[at] = v.z;
  }
  Wide3& operator+=(const Wide3& b) { return *this = Wide3(x + b.x, y + b.y, z + b.z); }
};

inline Wide3 operator+(const Wide3& a, const Wide3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Wide3 operator-(const Wide3& a, const Wide3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Wide3 operator-(const Wide3& a) { return {-a.x, -a.y, -a.z}; }
inline Wide3 operator*(const Wide3& a, const Wide3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Wide3 operator*(const Wide3& a, const Wide& s) { return {a.x * s, a.y * s, a.z * s}; }
inline Wide3 operator*(const Wide& s, const Wide3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Wide3 operator/(const Wide3& a, const Wide& s) { return {a.x / s, a.y / s, a.z / s}; }

inline Wide dot(const Wide3& a, const Wide3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Wide3 cross(const Wide3& a, const Wide3& b) {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
inline Wide length(const Wide3& a) { return sqrt(dot(a, a)); }
inline Wide3 normalize(const Wide3& a) { return a * (1.0 / sqrt(dot(a, a))); }
inline Wide max_abs(const Wide3& v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }
inline Wide3 select(const WideMask& m, const Wide3& a, const Wide3& b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
/// The lanes where no component is NaN or infinite.
inline WideMask all_finite(const Wide3& v) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  return abs(v.x) < inf && abs(v.y) < inf && abs(v.z) < inf;
}
inline Wide3 fused_at(const Wide3& origin, const Wide3& direction, const Wide& t) {
  return {fma(t, direction.x, origin.x), fma(t, direction.y, origin.y),
          fma(t, direction.z, origin.z)};
}

inline Wide3 operator*(const Mat3& m, const Wide3& v) {
  return {m[0][0] * v.x + m[1][0] * v.y + m[2][0] * v.z,
          m[0][1] * v.x + m[1][1] * v.y + m[2][1] * v.z,
          m[0][2] * v.x + m[1][2] * v.y + m[2][2] * v.z};
}
/// The transpose times v.
inline Wide3 operator*(const Wide3& v, const Mat3& m) {
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
          m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}
inline Wide3 point(const Affine& a, const Wide3& p) { return a.linear * p + Wide3(a.offset); }

}  // namespace rt
