#include "rt/geometry/sphere.h"

#include "convex.h"
#include "longitude.h"
#include "rt/math/rounding.h"
#include "wide.h"

namespace rt {
namespace {

/// The ray's origin seen from the centre, and what rounding took from it.
struct FromCentre {
  Vec3 origin;
  Vec3 lost;
};

FromCentre from_centre(const Sphere& shape, const Ray& ray) {
  FromCentre out;
  for (int i = 0; i < 3; ++i) {
    const DoublePair d = exact_difference(ray.origin[i], shape.centre[i]);
    out.origin[i] = d.high;
    out.lost[i] = d.low;
  }
  return out;
}

/// r^2 - h^2, with h the distance of line and centre: half the chord squared, times the
/// direction's. Rounding moves h^2 by at most gamma(6) r^2 around tangency; what is nearer to zero
/// than that is computed again in twice the digits.
double half_chord_squared(const Sphere& shape, const Ray& ray, const Recentred& line) {
  const double square = shape.radius * shape.radius;
  const double chord = square - glm::dot(line.origin, line.origin);
  if (!(std::abs(chord) <= 2 * gamma(6) * square)) {
    return chord;
  }
  const DoubleDouble t = DoubleDouble(line.shift) + line.residual;
  DoubleDouble wide = squared(DoubleDouble(shape.radius));
  for (int i = 0; i < 3; ++i) {
    wide += -squared(DoubleDouble(ray.origin[i]) - shape.centre[i] + t * ray.direction[i]);
  }
  return static_cast<double>(wide);
}

/// The side to which the ray leaves the sphere if its origin lies on it within `error`.
///
/// origin^2 is computed from three rounded differences, squares and two sums: its error is at most
/// gamma(5) origin^2, and the radius' square adds another rounding.
Leaving coincidence(const Vec3& origin, const Vec3& direction, double radius, double error) {
  const double square = glm::dot(origin, origin);
  const double off = std::abs(square - radius * radius);
  Touching touching;
  touching.face(off <= error * (2 * radius + error) + gamma(6) * (square + radius * radius),
                glm::dot(origin, direction));
  return touching.side();
}

}  // namespace

OptionalHit intersect(const Sphere& shape, const Ray& ray, double t_max, const RayStart& start) {
  if (start.leaving == Leaving::outward) {
    return {};
  }
  const Vec3& direction = ray.direction;
  const double direction_squared = glm::dot(direction, direction);
  const FromCentre from = from_centre(shape, ray);
  if (start.leaving == Leaving::inward) {
    // One root is 0 exactly, so the other is the negative linear term.
    return exit_hit(-2 * glm::dot(from.origin, direction) / direction_squared, 0, t_max);
  }
  Recentred line = recentred(from.origin, direction, direction_squared);
  line.origin += from.lost;
  const double chord = half_chord_squared(shape, ray, line);
  if (!(chord >= 0)) {
    return {};
  }
  const double half = std::sqrt(chord / direction_squared);
  if (start.position_error > 0) {
    const Leaving side = coincidence(from.origin, direction, shape.radius, start.position_error);
    if (side != Leaving::nothing) {
      return intersect(shape, ray, t_max, {side, 0, 0});
    }
  }
  return first_hit({line.ray_parameter(-half), line.ray_parameter(half)}, t_max);
}

SurfacePoint surface_point(const Sphere& shape, const Ray& ray, const ShapeHit& hit) {
  const FromCentre from = from_centre(shape, ray);
  const Vec3 normal = glm::normalize(fused_at(from.origin, ray.direction, hit.t) + from.lost);
  return {shape.centre + shape.radius * normal, normal, normal};
}

SurfaceCoordinates surface_coordinates(const Sphere& shape, const SurfacePoint& point,
                                       std::uint32_t) {
  const Vec3& n = point.normal;
  const Meridian m = meridian(n);
  const double r = shape.radius;
  return {{turns(n.z, n.x), 0.5 + std::atan2(n.y, m.radius) / std::numbers::pi},
          two_pi * r * Vec3(-n.z, 0, n.x),
          std::numbers::pi * r * Vec3(-n.y * m.cosine, m.radius, -n.y * m.sine)};
}

Vec3 normal_change(const Sphere& shape, const SurfacePoint&, std::uint32_t, const Vec3& step) {
  return step / shape.radius;
}

Bounds bounds(const Sphere& shape) {
  // One rounding a side, of the sum's own size.
  const Vec3 reach(shape.radius + gamma(2) * (shape.radius + max_abs(shape.centre)));
  return {shape.centre - reach, shape.centre + reach};
}

}  // namespace rt
