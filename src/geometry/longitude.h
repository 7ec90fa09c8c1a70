#pragma once
#include <cmath>
#include <numbers>

#include "rt/geometry/hit.h"

namespace rt {

inline constexpr double two_pi = 2 * std::numbers::pi;

/// An angle in turns, wrapped to [0, 1).
inline double turns(double sine, double cosine) {
  const double turn = std::atan2(sine, cosine) / two_pi;
  const double wrapped = turn < 0 ? turn + 1 : turn;
  return wrapped < 1 ? wrapped : 0;  // a tiny negative angle rounds up to a whole turn
}

/// Distance from the y axis, and the unit direction away from it; +x on the axis itself, where any
/// choice is the limit along some meridian.
struct Meridian {
  double radius;
  double cosine;
  double sine;
};

inline Meridian meridian(const Vec3& p) {
  const double radius = std::sqrt(p.x * p.x + p.z * p.z);
  if (radius > 0) {
    return {radius, p.x / radius, p.z / radius};
  }
  return {0, 1, 0};
}

/// How the normal of a cone about the y axis changes over a step: it turns with the longitude. 0 at
/// the apex, which has no normal.
inline Vec3 turned_about_axis(const SurfacePoint& point, const Vec3& step) {
  const Meridian m = meridian(point.position);
  if (!(m.radius > 0)) {
    return Vec3(0.0);
  }
  const Vec3 along(-m.sine, 0, m.cosine);
  const double level = m.cosine * point.normal.x + m.sine * point.normal.z;
  return level * glm::dot(step, along) / m.radius * along;
}

}  // namespace rt
