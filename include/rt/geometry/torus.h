#pragma once
#include "rt/geometry/hit.h"
#include "rt/math/bounds.h"

namespace rt {

/// The torus (|p|^2 - (R^2 + r^2))^2 = 4 R^2 (r^2 - y^2): a ring about the y axis. With R < r it is
/// a spindle torus: the implicit function is positive again in the lemon about the axis, which is
/// therefore outside the solid, as in any even-odd rule. Feature: always 0.
struct Torus {
  double major_radius = 1.0;   ///< R > 0
  double minor_radius = 0.25;  ///< r > 0
};

OptionalHit intersect(const Torus& shape, const Ray& ray, double t_max, const RayStart& start);
SurfacePoint surface_point(const Torus& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const Torus& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const Torus& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const Torus& shape);

}  // namespace rt
