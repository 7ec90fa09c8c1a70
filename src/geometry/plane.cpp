#include "rt/geometry/plane.h"

#include "convex.h"
#include "disc.h"

namespace rt {
namespace {

/// Where the ray meets y = 0; never again once it has left that plane, nor when it starts so close
/// to it that arithmetic cannot tell. (origin.y is itself the distance: there is no rounding of our
/// own to add.)
OptionalHit meet_plane(const Ray& ray, double t_max, const RayStart& start) {
  if (start.leaving != Leaving::nothing ||
      (start.position_error > 0 && std::abs(ray.origin.y) <= start.position_error)) {
    return {};
  }
  return hit_in_range(-ray.origin.y / ray.direction.y, 0, t_max);
}

/// |origin + t direction| <= half in one coordinate, at the exact crossing t = -y / dy rather than
/// at its rounded value: |origin * dy - y * direction| <= half * |dy|.
bool within(double origin, double direction, double y, double dy, double half) {
  return std::abs(difference_of_products(origin, dy, y, direction)) <= half * std::abs(dy);
}

}  // namespace

OptionalHit intersect(const Plane&, const Ray& ray, double t_max, const RayStart& start) {
  return meet_plane(ray, t_max, start);
}

SurfacePoint surface_point(const Plane&, const Ray& ray, const ShapeHit& hit) {
  return level_point(ray, hit.t, 0, 1);
}

SurfaceCoordinates surface_coordinates(const Plane&, const SurfacePoint& point, std::uint32_t) {
  return {{point.position.x, -point.position.z}, Vec3(1, 0, 0), Vec3(0, 0, -1)};
}

Vec3 normal_change(const Plane&, const SurfacePoint&, std::uint32_t, const Vec3&) {
  return Vec3(0.0);
}

Bounds bounds(const Plane&) { return {Vec3(-infinity), Vec3(infinity)}; }

OptionalHit intersect(const Square& shape, const Ray& ray, double t_max, const RayStart& start) {
  const OptionalHit hit = meet_plane(ray, t_max, start);
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double half = shape.edge / 2;
  if (hit && within(o.x, d.x, o.y, d.y, half) && within(o.z, d.z, o.y, d.y, half)) {
    return hit;
  }
  return {};
}

SurfacePoint surface_point(const Square&, const Ray& ray, const ShapeHit& hit) {
  return level_point(ray, hit.t, 0, 1);
}

SurfaceCoordinates surface_coordinates(const Square& shape, const SurfacePoint& point,
                                       std::uint32_t) {
  return {{0.5 + point.position.x / shape.edge, 0.5 - point.position.z / shape.edge},
          Vec3(shape.edge, 0, 0),
          Vec3(0, 0, -shape.edge)};
}

Vec3 normal_change(const Square&, const SurfacePoint&, std::uint32_t, const Vec3&) {
  return Vec3(0.0);
}

Bounds bounds(const Square& shape) {
  const double half = shape.edge / 2;
  return {Vec3(-half, 0, -half), Vec3(half, 0, half)};
}

}  // namespace rt
