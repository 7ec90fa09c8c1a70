#pragma once
#include "rt/geometry/hit.h"
#include "rt/math/bounds.h"

namespace rt {

/// The sphere |p - centre| = radius.
struct Sphere {
  Vec3 centre{0.0};
  double radius = 1.0;
};

OptionalHit intersect(const Sphere& shape, const Ray& ray, double t_max, const RayStart& start);
SurfacePoint surface_point(const Sphere& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const Sphere& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const Sphere& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const Sphere& shape);

}  // namespace rt
