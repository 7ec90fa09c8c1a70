#pragma once
#include "recentre.h"
#include "rt/geometry/double_double.h"

namespace rt {

/// A point of a ray in twice the digits. Rounding moves a line by a few u of the shape's size,
/// which decides whether it touches; here it does not.
struct WidePoint {
  DoubleDouble x, y, z;
};

/// ray.at(line.ray_parameter(s)).
inline WidePoint wide_point(const Ray& ray, const Recentred& line, double s) {
  const DoubleDouble t = DoubleDouble(line.shift) + line.residual + s;
  const auto at = [&](int i) { return DoubleDouble(ray.origin[i]) + t * ray.direction[i]; };
  return {at(0), at(1), at(2)};
}

inline DoubleDouble squared(const DoubleDouble& a) { return a * a; }

}  // namespace rt
