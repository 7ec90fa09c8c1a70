#pragma once
#include <cmath>
#include <optional>

#include "recentre.h"
#include "rt/geometry/torus.h"
#include "rt/math/rounding.h"

namespace rt {

inline double size_of(const Torus& torus) { return torus.major_radius + torus.minor_radius; }

/// Whether the hole is wide enough that the ring's features are all of the tube's size. Elsewhere
/// (a spindle's tips, where two sheets meet) they can be much smaller.
inline bool has_wide_hole(const Torus& torus) {
  return 2 * torus.minor_radius <= torus.major_radius;
}

/// The torus' quartic is the product of (rho - R)^2 + y^2 - r^2 and (rho + R)^2 + y^2 - r^2, where
/// rho is the distance from the axis. The first vanishes on the ring (a spindle torus' apple), the
/// second on the lemon inside a spindle torus. Each factor is a distance in disguise: its rounding
/// error moves the surface by a few u (R + r), where the quartic's would move it by R / r times as
/// much.
///
/// `sheet` = +1: the first factor; -1: the second.
inline double factor(const Torus& torus, double rho, double y, double sheet) {
  const double w = rho - sheet * torus.major_radius;
  const double r = torus.minor_radius;
  return w * w + (y - r) * (y + r);
}

/// Which of the two factors is nearer to zero, that is, of which sheet the point is.
inline double sheet_at(const Torus& torus, double rho, double y) {
  return std::abs(factor(torus, rho, y, 1)) <= std::abs(factor(torus, rho, y, -1)) ? 1 : -1;
}

/// A line that may meet a torus: origin + s * direction, direction of unit length. The origin is
/// that of `line`, or the ray's own with a `line` that says so.
struct TorusLine {
  const Torus& torus;
  const Ray& ray;
  Recentred line;
  Vec3 direction;
  double length;  ///< of ray.direction

  double size() const { return size_of(torus); }
  Vec3 at(double s) const { return fused_at(line.origin, direction, s); }
};

/// Finishes a root on the torus' own form. `s` lies near a root or near an extremum that is zero to
/// within the quartic's rounding error; `sign` is the quartic's sign just before it, `begin` where
/// that sign is known. Returns the crossing, or nothing when the line only comes near the surface.
std::optional<double> finish_root(const TorusLine& line, double s, double sign, double begin);

}  // namespace rt
