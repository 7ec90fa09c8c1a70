#pragma once
#include "rt/geometry/hit.h"
#include "rt/math/bounds.h"

namespace rt {

/// The gumdrop: a spherical head over a truncated cone, closed by a disc. Head: |p| = 1 for
/// y >= 1/sqrt(26). Body: sqrt(x^2 + z^2) = (sqrt(26) - y) / 5 for -1 <= y <= 1/sqrt(26). Position
/// and normal agree at the join. Feature: 0 head, 1 body, 2 base.
struct Blob {
  static constexpr double apex = 5.0990195135927848;  ///< sqrt(26): the cone's tip is at (0, apex, 0)
  static constexpr double join = 1 / apex;            ///< height at which head and body meet
};

OptionalHit intersect(const Blob& shape, const Ray& ray, double t_max, const RayStart& start);
SurfacePoint surface_point(const Blob& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const Blob& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const Blob& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const Blob& shape);

}  // namespace rt
