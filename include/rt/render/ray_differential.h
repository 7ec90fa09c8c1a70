#pragma once
/// Ray differentials (Igehy, "Tracing ray differentials", SIGGRAPH 1999), of one ray (V = Vec3) or
/// of several at a time (V = Wide3): how far apart neighbouring samples' rays are.
#include "rt/math/vec.h"

namespace rt {

/// Changes of a ray from one sample to the next across and down the picture.
template <class V>
struct RayDifferentialOf {
  V dp_dx, dp_dy;  ///< of the origin; at a hit, of the point on the surface
  V dd_dx, dd_dy;  ///< of the unit direction
};

/// A unit normal towards the ray, and its changes.
template <class V>
struct NormalDifferentialOf {
  V normal;
  V dn_dx, dn_dy;
};

/// Change of the unit vector along v when v changes by dv.
template <class V>
V unit_change(const V& v, const V& dv) {
  const auto size = length(v);
  const V unit = v / size;
  return (dv - dot(unit, dv) * unit) / size;
}

/// Carried over a distance t along `direction` (unit) onto the plane through the hit.
template <class V, class Real>
RayDifferentialOf<V> arrived(const RayDifferentialOf<V>& ray, const V& direction, const Real& t,
                             const V& normal) {
  const Real d_dot_n = dot(direction, normal);
  const auto on_plane = [&](const V& dp, const V& dd) -> V {
    const V carried = dp + t * dd;
    const V on = carried - dot(carried, normal) / d_dot_n * direction;
    return select(all_finite(on), on, carried);  // along the plane there is no crossing
  };
  return {on_plane(ray.dp_dx, ray.dd_dx), on_plane(ray.dp_dy, ray.dd_dy), ray.dd_dx, ray.dd_dy};
}

// R = D - 2 (D.N) N, differentiated.
template <class V>
RayDifferentialOf<V> reflected(const RayDifferentialOf<V>& at, const V& direction,
                               const NormalDifferentialOf<V>& n) {
  const auto d_dot_n = dot(direction, n.normal);
  const auto turned = [&](const V& dd, const V& dn) -> V {
    const auto change = dot(dd, n.normal) + dot(direction, dn);
    return dd - 2.0 * (d_dot_n * dn + change * n.normal);
  };
  return {at.dp_dx, at.dp_dy, turned(at.dd_dx, n.dn_dx), turned(at.dd_dy, n.dn_dy)};
}

// T = eta D - mu N with mu = eta D.N - T.N and (T.N)^2 = 1 - eta^2 (1 - (D.N)^2), differentiated.
/// eta: index before the surface over the index behind it. Where nothing is transmitted, `at`.
template <class V, class Real>
RayDifferentialOf<V> refracted(const RayDifferentialOf<V>& at, const V& direction,
                               const NormalDifferentialOf<V>& n, const Real& eta) {
  using std::sqrt;
  const Real d_dot_n = dot(direction, n.normal);
  const Real square = 1.0 - eta * eta * (1.0 - d_dot_n * d_dot_n);
  const Real t_dot_n = -sqrt(square);
  const Real mu = eta * d_dot_n - t_dot_n;
  const Real rate = eta - eta * eta * d_dot_n / t_dot_n;
  const auto turned = [&](const V& dd, const V& dn) -> V {
    const Real change = dot(dd, n.normal) + dot(direction, dn);
    const V turn = eta * dd - (mu * dn + rate * change * n.normal);
    return select(square > 0.0, turn, dd);
  };
  return {at.dp_dx, at.dp_dy, turned(at.dd_dx, n.dn_dx), turned(at.dd_dy, n.dn_dy)};
}

}  // namespace rt
