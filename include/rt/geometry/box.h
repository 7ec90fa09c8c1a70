#pragma once
#include "rt/geometry/hit.h"
#include "rt/math/bounds.h"

namespace rt {

/// The solid box lo <= p <= hi. Feature: 2 * axis, plus 1 for the face at hi.
struct Box {
  Vec3 lo{0.0};
  Vec3 hi{1.0};
};

OptionalHit intersect(const Box& shape, const Ray& ray, double t_max, const RayStart& start);
SurfacePoint surface_point(const Box& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const Box& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const Box& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const Box& shape);

}  // namespace rt
