#pragma once
#include "rt/geometry/hit.h"
#include "rt/math/bounds.h"

namespace rt {

/// The solid x^2 + z^2 <= (1 - y)^2, 0 <= y <= 1: radius 1 at y = 0, where a disc closes it, and
/// its apex at (0, 1, 0). Feature: 0 side, 1 disc.
struct PointedCone {};

OptionalHit intersect(const PointedCone& shape, const Ray& ray, double t_max,
                      const RayStart& start);
SurfacePoint surface_point(const PointedCone& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const PointedCone& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const PointedCone& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const PointedCone& shape);

}  // namespace rt
