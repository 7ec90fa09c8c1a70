#pragma once
#include "rt/geometry/hit.h"
#include "rt/math/bounds.h"

namespace rt {

/// All that is within `radius` of the straight line from (0, 0, 0) to (0, length, 0): a cylinder
/// that ends in half balls. Feature: 0 side, 1 lower half ball, 2 upper.
struct Capsule {
  double length = 1.0;   ///< > 0, between the balls' centres
  double radius = 0.25;  ///< > 0
};

OptionalHit intersect(const Capsule& shape, const Ray& ray, double t_max, const RayStart& start);
SurfacePoint surface_point(const Capsule& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const Capsule& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const Capsule& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const Capsule& shape);

}  // namespace rt
