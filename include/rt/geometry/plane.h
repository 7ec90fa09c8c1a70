#pragma once
#include "rt/geometry/hit.h"
#include "rt/math/bounds.h"

namespace rt {

/// The unbounded plane y = 0, normal +y. It encloses nothing: below it is its inner side.
struct Plane {};

/// The square |x|, |z| <= edge / 2 in the plane y = 0, normal +y.
struct Square {
  double edge = 1.0;
};

OptionalHit intersect(const Plane& shape, const Ray& ray, double t_max, const RayStart& start);
SurfacePoint surface_point(const Plane& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const Plane& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const Plane& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const Plane& shape);

OptionalHit intersect(const Square& shape, const Ray& ray, double t_max, const RayStart& start);
SurfacePoint surface_point(const Square& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const Square& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const Square& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const Square& shape);

}  // namespace rt
