#pragma once
/// Along a line with o . d = 0 and |d| = 1 the ring's factor is F(s) = s^2 + a - 2 R rho(s), rho
/// the distance from the axis. With k = dx^2 + dz^2 and D = (ox dz - oz dx)^2, which is rho^2 (k -
/// rho'^2), the derivatives are rho' = (k s + ox dx + oz dz) / rho and rho'' = D / rho^3, hence
///   F'' = 2 - 2 R D / rho^3,  F''' = 6 R D rho' / rho^4,
///   F'''' = 6 R D (D - 4 rho^2 rho'^2) / rho^7, at most 6 R / rho^3 in size, as D / rho^2 and
///   rho'^2 add up to at most 1 (D (D - 4 rho^2 rho'^2) is at most rho^4 in size).
#include <type_traits>

#include "rt/math/rounding.h"
#include "torus_form.h"

namespace rt {

/// The ring's factor and its derivatives at one place. Real: a number, or several at a time.
template <class Real>
struct RingJet {
  Real value, slope, curvature;
  Real twist;   ///< a sixth of the third derivative
  Real square;  ///< rho^2

  Real discriminant() const { return slope * slope - 2 * value * curvature; }
};

/// The ring's factor along a line: o its point nearest to the centre, d of unit length.
template <class Real, class Point>
struct RingAlongLine {
  Point o, d;
  double R, r;
  Real k = d.x * d.x + d.z * d.z;
  Real b = o.x * d.x + o.z * d.z;
  Real D = (o.x * d.z - o.z * d.x) * (o.x * d.z - o.z * d.x);

  RingAlongLine(const Point& nearest, const Point& direction, const Torus& torus)
      : o(nearest), d(direction), R(torus.major_radius), r(torus.minor_radius) {}

  double size() const { return R + r; }
  auto has_one_dip() const { return D >= k * k * k * R * R; }

  /// The place is known to 4 u (R + r) and rho to the same, which the value takes times 2 |p| and
  /// 2 |w|; its own roundings add a few u (R + r)^2.
  double noise() const { return 64 * unit_roundoff * size() * size(); }

  /// Both terms of the slope are at most 2 (R + r), after at most ten roundings each, and in `b`
  /// (and o . d, which is not quite 0) a few u (R + r) come times R / rho, below 4 where the
  /// slope's sign matters.
  double slope_noise() const { return 128 * unit_roundoff * size(); }

  RingJet<Real> at(const Real& s) const {
    using std::sqrt;
    const Point p = fused_at(o, d, s);
    const Real square = p.x * p.x + p.z * p.z;
    const Real rho = sqrt(square);
    const Real inverse_square = 1 / square;
    const Real ratio = rho * (R * inverse_square);
    const Real w = rho - R;
    const Real climb = k * s + b;
    const Real bend = ratio * (D * inverse_square);
    return {w * w + (p.y - r) * (p.y + r), 2 * (s - climb * ratio), 2 - 2 * bend,
            bend * (climb * inverse_square), square};
  }
};

using Ring = RingAlongLine<double, Vec3>;

/// A step to the first root of the parabola that fits, or to its vertex if it has none. `fall`: how
/// steeply it falls at that root.
template <class Real>
struct RingStep {
  Real length, fall;
};

/// Both ways to write the root share one division. (Choosing between them without a branch waits
/// for the square root longer than a wrong guess costs.)
inline RingStep<double> step_to_root(const RingJet<double>& jet) {
  const double discriminant = jet.discriminant();
  const bool real = discriminant >= 0;
  const double fall = std::sqrt(real ? discriminant : 0.0);
  const bool falling = real & (jet.slope < 0);
  const double numerator = falling ? 2 * jet.value : -(jet.slope + fall);
  const double denominator = falling ? fall - jet.slope : jet.curvature;
  return {numerator / denominator, fall};
}

/// The step lands within 2 u (R + r) of the root. What it leaves is the cubic term, and the quartic
/// one (R / (4 rho^3) of the fourth power, rho >= (R + r) / 4), over the slope.
template <class Real, class Point>
auto settled(const RingAlongLine<Real, Point>& ring, const RingJet<Real>& jet,
             const RingStep<Real>& step) {
  using std::abs;
  const Real h = abs(step.length);
  const double size = ring.size();
  return h * h * h * (abs(jet.twist) * jet.square * size + ring.R * h) <=
         2 * unit_roundoff * size * size * step.fall * jet.square;
}

/// Whether the dip's lowest point is within twice Newton's step to it, delta = |F'| / F'', because
/// F'' is at least half its value up to there. Then it is no lower than F - F'^2 / F''.
///
/// |F'''| <= 2.4 R / rho^2, for D |rho'| is at most 0.39 rho^2. Let 24 R delta <= F'' rho^2. Then
/// delta <= rho^2 / (12 R), below 0.18 rho as rho < 2.13 R (see search_dip), rho does not fall
/// below 0.64 of its value within 2 delta, |F'''| stays below 5.9 R / rho^2, and F'' changes by
/// less than 11.8 R delta / rho^2, less than half.
template <class Real, class Point>
auto is_near_lowest(const RingAlongLine<Real, Point>& ring, const RingJet<Real>& jet) {
  using std::abs;
  return 24 * ring.R * abs(jet.slope) <= jet.curvature * jet.curvature * jet.square;
}

}  // namespace rt
