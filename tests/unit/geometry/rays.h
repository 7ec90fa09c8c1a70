#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rt/geometry/shape.h"
#include "rt/math/transform.h"

namespace rt::testing {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class S>
OptionalHit hit(const S& shape, const Vec3& origin, const Vec3& direction,
                const RayStart& start = {}) {
  return intersect(shape, Ray{origin, direction}, infinity, start);
}

/// t of the hit, or -1 where there is none.
template <class S>
double t_of(const S& shape, const Vec3& origin, const Vec3& direction, const RayStart& start = {}) {
  const OptionalHit h = hit(shape, origin, direction, start);
  return h ? h->t : -1;
}

template <class S>
SurfacePoint point_of(const S& shape, const Vec3& origin, const Vec3& direction) {
  const Ray ray{origin, direction};
  const OptionalHit h = intersect(shape, ray, infinity, {});
  EXPECT_TRUE(h.has_value());
  return surface_point(shape, ray, h.value_or(ShapeHit{0, 0}));
}

inline void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

inline RayStart leaving(Leaving side, std::uint32_t feature = 0) { return {side, feature, 0}; }
inline RayStart near_start(double position_error) { return {Leaving::nothing, 0, position_error}; }

}  // namespace rt::testing
