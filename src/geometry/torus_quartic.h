#pragma once
#include "torus_form.h"

namespace rt {

/// The quartic along a line through its point nearest to the centre, direction of unit length: the
/// cubic term vanishes. s^4 + c2 s^2 + c1 s + c0.
/// Real: a number, or several at a time.
template <class Real>
struct QuarticOf {
  Real c2, c1, c0;

  Real operator()(const Real& s) const { return ((s * s + c2) * s + c1) * s + c0; }
  Real slope(const Real& s) const { return (4 * s * s + 2 * c2) * s + c1; }
  Real curvature(const Real& s) const { return 12 * s * s + 2 * c2; }
};
using Quartic = QuarticOf<double>;

/// `square`: o . o.
template <class Point, class Real>
QuarticOf<Real> quartic_of(const Torus& torus, const Point& o, const Point& d, const Real& square) {
  const double R = torus.major_radius;
  const double r = torus.minor_radius;
  const Real& h = square;
  const double R4 = 4 * R * R;
  // The constant term, h - R^2 - r^2 squared less 4 R^2 (r^2 - y^2), in factored form.
  return {2 * (h - R * R - r * r) + R4 * d.y * d.y, 2 * R4 * o.y * d.y,
          (h - (R + r) * (R + r)) * (h - (R - r) * (R - r)) + R4 * o.y * o.y};
}
inline Quartic quartic_of(const Torus& torus, const Vec3& o, const Vec3& d) {
  return quartic_of(torus, o, d, glm::dot(o, o));
}

/// The quartic from a point of the torus along d of unit length, divided by its root 0 there:
/// s^3 + c2 s^2 + c1 s + c0.
template <class Real>
struct CubicOf {
  Real c2, c1, c0;

  Real operator()(const Real& s) const { return ((s + c2) * s + c1) * s + c0; }
  Real slope(const Real& s) const { return (3 * s + 2 * c2) * s + c1; }
  Real curvature(const Real& s) const { return 6 * s + 2 * c2; }
};
using Cubic = CubicOf<double>;

/// `rho`: the point's distance from the axis. The last term is the gradient of the product of both
/// factors where that of `sheet` is zero: well-conditioned however thin the ring.
template <class Point, class Real>
CubicOf<Real> cubic_of(const Torus& torus, const Point& o, const Point& d, const Real& rho,
                       double sheet) {
  const double R = torus.major_radius;
  const double r = torus.minor_radius;
  const Real od = dot(o, d);
  return {4 * od, 2 * (dot(o, o) - R * R - r * r) + 4 * od * od + 4 * R * R * d.y * d.y,
          8 * R * ((sheet * rho - R) * (o.x * d.x + o.z * d.z) + sheet * rho * o.y * d.y)};
}

/// Halley's step comes nearer to a root than the vertex is while the parabola's bend is below so
/// much of the slope's square; a parabola with its root at its vertex has half of it.
inline constexpr double shallow = 0.47;

/// A step towards the next root, cheap because it waits for no square root, and good because it is
/// the first of two or three: Halley's while the parabola that fits has a root well before its
/// vertex, otherwise the step to the vertex, near which a double root's crossing is.
inline double nearer_root(const Quartic& quartic, double s) {
  const double value = quartic(s);
  const double slope = quartic.slope(s);
  const double square = slope * slope;
  const double bend = value * quartic.curvature(s);
  return s - slope * value / (bend > shallow * square ? bend : square - 0.5 * bend);
}

/// 64 u, times the size to the power of the polynomial's degree: bounds the rounding error of the
/// quartic, and of the cubic that is left of it for a line that starts on the torus. With lengths
/// in units of R + r their terms are at most 1, 8, 8 and 5 in size, through at most eight roundings
/// each on the way: less than 22 * 3 u on average, and the sum of all terms never comes near all
/// its bounds at once.
inline constexpr double polynomial_noise = 64 * 2 * unit_roundoff;

/// A polynomial's iteration stops at steps below this. What it leaves is of the order of the step's
/// square, and the finish on the geometric form, of third order over distances below the tube's
/// radius, takes that to rounding in one step. Where the hole is narrow or closed the torus has
/// features much smaller than that radius (a spindle's tips, where two sheets meet): there the
/// polynomial is followed down to rounding, so that the finish cannot stray to another root.
inline double coarse_step(const Torus& torus) {
  return (has_wide_hole(torus) ? 0x1p-8 : 0x1p-26) * torus.minor_radius;
}

/// The first crossing between begin and end by the quartic alone, whatever the torus and wherever
/// the line begins; `sign` is the quartic's sign at its beginning.
std::optional<double> first_quartic_root(const TorusLine& line, double begin, double end,
                                         double sign);

}  // namespace rt
