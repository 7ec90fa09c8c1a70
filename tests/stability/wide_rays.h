#pragma once
/// Several rays at a time against one at a time: every lane is undecided, or has the scalar
/// function's answer bit for bit.
#include <array>
#include <cmath>
#include <sstream>

#include "rt/geometry/wide_shapes.h"
#include "stability/families.h"

namespace rt::stability {

constexpr auto lane_count = static_cast<std::size_t>(lanes);

struct LaneRays {
  std::array<Ray, lane_count> ray;
  std::array<double, lane_count> t_max;
  std::array<double, lane_count> error{};  ///< all zero, or none

  WideRay wide() const {
    WideRay out;
    for (int i = 0; i < lanes; ++i) {
      out.origin.set(i, ray[static_cast<std::size_t>(i)].origin);
      out.direction.set(i, ray[static_cast<std::size_t>(i)].direction);
    }
    return out;
  }
};

inline Wide packed(const std::array<double, lane_count>& v) {
  return Wide([&](auto i) { return v[i]; });
}

inline std::string described(const Ray& r) {
  std::ostringstream out;
  out << std::hexfloat << r.origin.x << ' ' << r.origin.y << ' ' << r.origin.z << " towards "
      << r.direction.x << ' ' << r.direction.y << ' ' << r.direction.z;
  return out.str();
}

/// A point of a ray that is not one may be none.
inline bool same(const Vec3& a, const Vec3& b) {
  const auto one = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return one(a.x, b.x) && one(a.y, b.y) && one(a.z, b.z);
}

/// What came of lanes.
struct LaneTally {
  long lanes = 0;
  long decided = 0;
  long hits = 0;  ///< among the decided
  long wrong = 0;
  std::string first_wrong;

  double share() const { return static_cast<double>(decided) / static_cast<double>(lanes); }
  void complain(const std::string& what, const Ray& ray) {
    if (wrong++ == 0) {
      first_wrong = what + ": " + described(ray);
    }
  }
};

/// Compares one lane.
template <class S>
void compare_lane(const S& shape, const LaneRays& rays, std::size_t i, const WideHit& wide,
                  const WideSurfacePoint& point, const Wide3& wide_change, LaneTally& tally) {
  const Ray& ray = rays.ray[i];
  ++tally.lanes;
  if (wide.undecided[i]) {
    if (wide.hit[i]) {
      tally.complain("undecided, yet a hit", ray);
    }
    return;
  }
  ++tally.decided;
  const OptionalHit one =
      intersect(shape, ray, rays.t_max[i], {Leaving::nothing, 0, rays.error[i]});
  if (bool{wide.hit[i]} != one.has_value()) {
    tally.complain(one ? "lost" : "invented", ray);
  } else if (one) {
    ++tally.hits;
    const SurfacePoint p = surface_point(shape, ray, *one);
    if (wide.t[i] != one->t || wide.feature[i] != double{1.0} * one->feature) {
      tally.complain("another crossing", ray);
    } else if (!same(point.position.lane(static_cast<int>(i)), p.position) ||
               !same(point.normal.lane(static_cast<int>(i)), p.normal)) {
      tally.complain("another point", ray);
    } else if (const Vec3 change = normal_change(shape, p, one->feature, ray.origin - p.position);
               !same(wide_change.lane(static_cast<int>(i)), change)) {
      tally.complain("another curvature", ray);
    }
  }
}

/// Compares all lanes of a shape; `only`: or one of them.
inline void compare(const Shape& any_shape, const LaneRays& rays, LaneTally& tally,
                    std::optional<std::size_t> only = {}) {
  std::visit(
      [&](const auto& shape) {
        if constexpr (WideShape<std::decay_t<decltype(shape)>>) {
          const WideRay ray = rays.wide();
          const WideHit hit = intersect(shape, ray, packed(rays.t_max), packed(rays.error));
          const WideSurfacePoint point = surface_point(shape, ray, hit.t, hit.feature);
          // Over any step: it is linear.
          const Wide3 change =
              normal_change(shape, point, hit.feature, ray.origin - point.position);
          for (std::size_t i = 0; i < lane_count; ++i) {
            if (!only || *only == i) {
              compare_lane(shape, rays, i, hit, point, change, tally);
            }
          }
        }
      },
      any_shape);
}

}  // namespace rt::stability
