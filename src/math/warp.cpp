#include "rt/math/warp.h"

#include <algorithm>

#include "rt/math/wide_functions.h"

namespace rt {
namespace {

template <class Real>
struct CosSin {
  Real cos, sin;
};

/// For |x| <= pi/4, by Taylor's series. The first terms left out are x^17/17! < 5e-17 and
/// x^18/18! < 3e-18, below the rounding of the result. The library's functions would do but for
/// their last bit, which differs between its versions.
template <class Real>
CosSin<Real> cos_sin_octant(const Real& x) {
  using std::fma;
  const Real q = x * x;
  Real s = -1.0 / 1307674368000.0;
  Real c = 1.0 / 20922789888000.0;
  const auto next = [&q](Real& sum, double term) { sum = fma(sum, q, Real(term)); };
  next(s, 1.0 / 6227020800.0);
  next(c, -1.0 / 87178291200.0);
  next(s, -1.0 / 39916800.0);
  next(c, 1.0 / 479001600.0);
  next(s, 1.0 / 362880.0);
  next(c, -1.0 / 3628800.0);
  next(s, -1.0 / 5040.0);
  next(c, 1.0 / 40320.0);
  next(s, 1.0 / 120.0);
  next(c, -1.0 / 720.0);
  next(s, -1.0 / 6.0);
  next(c, 1.0 / 24.0);
  next(c, -0.5);
  return {fma(c, q, Real(1.0)), fma(s * q, x, x)};
}

}  // namespace

// With (a, b) in [-1,1]^2, the square splits into four triangles by its diagonals. In the right
// one, r = a and phi = (pi/4)(b/a): dr dphi r = (pi/4) da db, a constant Jacobian. The others
// follow by symmetry; a negative r in the left and the lower one points to the opposite side.
Vec2 to_disc(const Vec2& u) {
  const double a = 2.0 * u.x - 1.0;
  const double b = 2.0 * u.y - 1.0;
  if (std::abs(a) >= std::abs(b)) {
    if (a == 0.0) {
      return {0.0, 0.0};
    }
    const auto e = cos_sin_octant(pi / 4 * (b / a));
    return {a * e.cos, a * e.sin};
  }
  const auto e = cos_sin_octant(pi / 4 * (a / b));
  return {b * e.sin, b * e.cos};
}

Wide2 to_disc(const Wide2& u) {
  const Wide a = 2.0 * u.x - 1.0;
  const Wide b = 2.0 * u.y - 1.0;
  const WideMask right = abs(a) >= abs(b);
  const Wide major = select(right, a, b);
  const Wide minor = select(right, b, a);
  const auto e = cos_sin_octant(Wide(pi / 4) * (minor / major));
  const WideMask centre = major == 0.0;
  const Wide along = select(centre, Wide(0.0), major * e.cos);
  const Wide across = select(centre, Wide(0.0), major * e.sin);
  return {select(right, along, across), select(right, across, along)};
}

DiscPoint disc_polar(const Vec2& u) {
  const double a = 2.0 * u.x - 1.0;
  const double b = 2.0 * u.y - 1.0;
  DiscPoint p{std::max(std::abs(a), std::abs(b)), 0.0, to_disc(u)};
  if (p.r == 0.0) {
    return p;
  }
  if (std::abs(a) < std::abs(b)) {
    p.phi = std::copysign(pi / 2, b) - pi / 4 * (a / b);
  } else if (a > 0.0) {
    p.phi = pi / 4 * (b / a);
  } else {
    p.phi = std::copysign(pi, b) + pi / 4 * (b / a);
  }
  return p;
}

Vec3 to_cosine_hemisphere(const Vec2& u) {
  const double a = std::abs(2.0 * u.x - 1.0);
  const double b = std::abs(2.0 * u.y - 1.0);
  const double r = std::max(a, b);
  return {to_disc(u), std::sqrt((1.0 - r) * (1.0 + r))};
}

// A cap's area is proportional to its height (Archimedes), so r^2 of a uniform disc point, uniform
// in [0,1], gives 1 - cos = h r^2. Then sin = sqrt((1-cos)(1+cos)) = r sqrt(h (2 - h r^2)), without
// subtracting near-equal numbers at either end.
Vec3 to_cone(const Vec2& u, const Cone& cone) {
  const Vec2 d = to_disc(u);
  const double h = cone.one_minus_cos;
  const double height = h * glm::dot(d, d);
  return {d * std::sqrt(h * std::max(0.0, 2.0 - height)), 1.0 - height};
}

// With d the distance of the centre, h = 1 - cos of the cone and q = 1 - cos of the direction
// drawn, the near side stands at t = d cos - sqrt(radius^2 - d^2 sin^2). Now radius^2 / d^2 = h (2
// - h) and sin^2 = q (2 - q); their difference factors into (h - q)(2 - h - q). The product of the
// near and the far root is d^2 - radius^2, which gives the near one without cancellation.
std::optional<SphereSample> sample_sphere(const Vec2& u, const Vec3& p, const Vec3& centre,
                                          double radius) {
  const Vec3 to_centre = centre - p;
  const double d = glm::length(to_centre);
  if (!(d > radius)) {
    return std::nullopt;
  }
  const double ratio = radius / d;
  const double cos_cone = std::sqrt((d - radius) * (d + radius)) / d;
  const Cone cone{ratio * ratio / (1.0 + cos_cone)};
  const Vec3 local = to_cone(u, cone);
  const double h = cone.one_minus_cos;
  const double r = std::max(std::abs(2.0 * u.x - 1.0), std::abs(2.0 * u.y - 1.0));
  const double q = h * r * r;
  const double half_chord = d * std::sqrt(std::max(0.0, (h - q) * (2.0 - h - q)));
  const double t = (d - radius) * (d + radius) / (d * (1.0 - q) + half_chord);
  return SphereSample{frame_about(to_centre / d).to_world(local), t, cone.pdf()};
}

}  // namespace rt
