#pragma once
#include "rt/geometry/exact.h"
#include "rt/geometry/hit.h"

namespace rt {

/// A hit of a plane y = const., which faces up (side 1) or down (-1).
inline SurfacePoint level_point(const Ray& ray, double t, double y, double side) {
  Vec3 p = fused_at(ray.origin, ray.direction, t);
  p.y = y;
  const Vec3 normal(0, side, 0);
  return {p, normal, normal};
}

/// Of a disc of radius 1 about the y axis: seen from outside, unmirrored, u along +x.
inline SurfaceCoordinates disc_coordinates(const Vec3& p, double side) {
  return {{(1 + p.x) / 2, (1 - side * p.z) / 2}, Vec3(2, 0, 0), Vec3(0, 0, -2 * side)};
}

}  // namespace rt
