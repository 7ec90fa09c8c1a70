#pragma once
#include "rt/geometry/hit.h"
#include "rt/math/bounds.h"

namespace rt {

/// The solid x^2 + z^2 <= 1, 0 <= y <= 1, closed by its two discs. Feature: 0 side, 1 disc at
/// y = 0, 2 disc at y = 1.
struct Cylinder {};

OptionalHit intersect(const Cylinder& shape, const Ray& ray, double t_max, const RayStart& start);
SurfacePoint surface_point(const Cylinder& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const Cylinder& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const Cylinder& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const Cylinder& shape);

}  // namespace rt
