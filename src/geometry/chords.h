#pragma once
/// Where a line lies inside the surfaces about the y axis that solids are made of. Each function
/// cuts a chord, in the line's local parameter, down to that part: to nothing where the line passes
/// by. Where rounding would decide whether it does, twice the digits do.
#include <algorithm>

#include "convex.h"
#include "rt/math/rounding.h"
#include "wide.h"

namespace rt {

/// Cuts down to `half` on either side of `middle`; a NaN (the root of a negative number) to
/// nothing.
inline void clip_about(Chord& chord, double middle, double half, std::uint32_t feature) {
  if (half >= 0) {
    chord.clip(middle - half, feature, middle + half, feature);
  } else {
    chord.t_out = -infinity;
  }
}

/// A ball, or an unbounded cylinder about the y axis.
struct Round {
  double radius;
  /// Bounds the rounding error of radius^2 - distance^2 where a line touches the solid: two
  /// recentrings, squares and sums of quantities of the solid's size.
  double noise;
};

/// The ball about (0, height, 0).
inline void clip_ball(Chord& chord, const Round& ball, double height, const Ray& ray,
                      const Recentred& line, double direction_squared, std::uint32_t feature) {
  Vec3 p = line.origin;
  double middle = 0;
  if (height != 0) {  // else the line is seen from its point nearest to the ball's centre already
    p.y -= height;
    middle = -glm::dot(p, ray.direction) / direction_squared;
    p = fused_at(p, ray.direction, middle);
  }
  double square = ball.radius * ball.radius - glm::dot(p, p);
  if (std::abs(square) <= ball.noise) {
    const WidePoint w = wide_point(ray, line, middle);
    square = static_cast<double>(squared(DoubleDouble(ball.radius)) - squared(w.x) -
                                 squared(w.y - height) - squared(w.z));
  }
  clip_about(chord, middle, std::sqrt(square / direction_squared), feature);
}

/// The cylinder x^2 + z^2 <= radius^2. `across` = dx^2 + dz^2.
inline void clip_cylinder(Chord& chord, const Round& cylinder, const Ray& ray,
                          const Recentred& line, double across, std::uint32_t feature) {
  const Vec3& o = line.origin;
  const Vec3& d = ray.direction;
  if (!(across > 0)) {
    // Parallel to the axis: inside or not, exactly.
    const DoubleDouble off =
        squared(DoubleDouble(ray.origin.x)) + squared(DoubleDouble(ray.origin.z));
    chord.t_out = off <= squared(DoubleDouble(cylinder.radius)) ? chord.t_out : -infinity;
    return;
  }
  // From the line's point nearest to the axis, so that nothing cancels: see recentre.h.
  const double middle = -(o.x * d.x + o.z * d.z) / across;
  const double x = std::fma(middle, d.x, o.x);
  const double z = std::fma(middle, d.z, o.z);
  double square = cylinder.radius * cylinder.radius - (x * x + z * z);
  if (std::abs(square) <= cylinder.noise) {
    const WidePoint w = wide_point(ray, line, middle);
    square =
        static_cast<double>(squared(DoubleDouble(cylinder.radius)) - squared(w.x) - squared(w.z));
  }
  clip_about(chord, middle, std::sqrt(square / across), feature);
}

/// The nappe below the apex of a cone about the y axis, which falls by `steepness` for each unit
/// that it widens.
struct Nappe {
  double apex;          ///< its height
  double apex_squared;  ///< exactly
  double steepness;
  double moved = 0;  ///< how far rounding may have moved the line, if not relatively to its origin

  constexpr double width_at(double y) const { return (apex - y) / steepness; }
};

/// The nappe as a quadratic along a line: a t^2 + 2 b t + c <= 0 inside, of
/// x^2 + z^2 - ((apex - y) / steepness)^2.
struct NappeQuadratic {
  double a, b, c;
  double noise;  ///< bounds the rounding error of b^2 - a c, of whose terms some cancel

  NappeQuadratic(const Nappe& nappe, const Vec3& o, const Vec3& d) {
    const double width = nappe.width_at(o.y);
    const double growth = -d.y / nappe.steepness;
    const double across = d.x * d.x + d.z * d.z;
    const double radius = o.x * o.x + o.z * o.z;
    const double along = o.x * d.x + o.z * d.z;
    a = across - growth * growth;
    b = along - width * growth;
    c = radius - width * width;
    // Each of the three: two products, one or two factors rounded before, two sums. Twice, for the
    // recentring before.
    const double b_terms = std::abs(o.x * d.x) + std::abs(o.z * d.z) + std::abs(width * growth);
    noise = 2 * gamma(6) *
                (2 * std::abs(b) * b_terms + std::abs(a) * (radius + width * width) +
                 std::abs(c) * (across + growth * growth)) +
            // The value at the vertex, which is -1/a times that, changes by its gradient.
            2 * nappe.moved * std::abs(a) * (std::abs(o.x) + std::abs(o.z) + std::abs(width));
  }

  /// The end of the chord of a ray that starts on the nappe, going inward: one root is 0 exactly,
  /// so the other is the negative linear term.
  double exit_from_surface() const { return a > 0 ? -2 * b / a : infinity; }
};

/// The quadratic's discriminant. For a line flatter than the slope it is -a times the value at the
/// vertex -b / a, which decides tangency; where rounding would, that value is computed in twice the
/// digits. A steeper line always crosses twice (at the apex' height it is not inside).
inline double discriminant(const Nappe& nappe, const NappeQuadratic& q, const Ray& ray,
                           const Recentred& line) {
  const double value = difference_of_products(q.b, q.b, q.a, q.c);
  if (!(q.a > 0 && std::abs(value) <= q.noise)) {
    return q.a < 0 ? std::max(value, 0.0) : value;
  }
  const WidePoint p = wide_point(ray, line, -q.b / q.a);
  const DoubleDouble width = (sqrt(DoubleDouble(nappe.apex_squared)) - p.y) / nappe.steepness;
  return -q.a * static_cast<double>(squared(p.x) + squared(p.z) - squared(width));
}

inline void clip_nappe(Chord& chord, const Nappe& nappe, const Ray& ray, const Recentred& line,
                       std::uint32_t feature) {
  const Vec3& o = line.origin;
  const Vec3& d = ray.direction;
  const NappeQuadratic q(nappe, o, d);
  const double root = std::sqrt(discriminant(nappe, q, ray, line));
  const double sum = -(q.b + std::copysign(root, q.b));
  const bool steeper = q.a < 0;
  // The root without cancellation, and the other from the product of the two. As a goes through
  // zero (the line turns parallel to the cone's slope) first goes to infinity, as it should. Both
  // are 0 where a steeper line goes through the apex.
  const double first = sum / q.a;
  const double second = sum == 0 && steeper ? first : q.c / sum;
  const double lo = std::min(first, second);
  const double hi = std::max(first, second);
  // A flatter line crosses one nappe twice: the other one, perhaps, or at most touches the apex.
  const bool below_apex = steeper || (sum != 0 && o.y + second * d.y <= nappe.apex);
  if (!(root >= 0 && below_apex)) {
    chord.t_out = -infinity;
  } else if (!steeper) {
    chord.clip(lo, feature, hi, feature);
  } else if (d.y < 0) {  // downward the line stays inside for ever
    chord.clip(hi, feature, infinity, feature);
  } else {
    chord.clip(-infinity, feature, lo, feature);
  }
}

}  // namespace rt
