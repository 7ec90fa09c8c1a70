#pragma once
#include "rt/geometry/exact.h"
#include "rt/math/ray.h"

namespace rt {

/// A line seen from its point nearest to the model's origin: p(s) = origin + s * direction, where
/// the ray's own parameter is t = shift + (residual + s).
///
/// Why: an intersection solved at the ray's origin loses |origin| / size of its digits, squared for
/// a quadric's and to the fourth power for a torus' constant term. Here every quantity is of the
/// shape's own size. `origin` is the exact point at the rounded parameters `shift`, `residual`,
/// rounded once per component, so the line moves by at most u |origin| whatever the distance.
struct Recentred {
  Vec3 origin;
  double shift;
  double residual;

  double ray_parameter(double s) const { return shift + (residual + s); }
  double local_parameter(double t) const { return (t - shift) - residual; }
};

/// `direction_squared` = dot(direction, direction). Two steps: the first leaves origin.direction of
/// the order of u |ray origin| |direction|, the second of u |origin| |direction|.
inline Recentred recentred(const Vec3& origin, const Vec3& direction, double direction_squared) {
  const double scale = -1 / direction_squared;
  const double shift = glm::dot(origin, direction) * scale;
  const Vec3 near = fused_at(origin, direction, shift);
  const double residual = glm::dot(near, direction) * scale;
  return {fused_at(near, direction, residual), shift, residual};
}

}  // namespace rt
