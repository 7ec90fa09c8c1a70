#pragma once
#include <cmath>
#include <optional>

#include "longitude.h"
#include "rt/geometry/torus.h"
#include "rt/math/rounding.h"

namespace rt {

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

/// A factor along the line origin + s * direction, with its first two derivatives.
struct FactorJet {
  double value, slope, curvature;
};

inline FactorJet factor_jet(const Torus& torus, const Vec3& p, const Vec3& d, double sheet) {
  const double rho = std::sqrt(p.x * p.x + p.z * p.z);
  const double w = rho - sheet * torus.major_radius;
  const double inverse = rho > 0 ? 1 / rho : 0;
  const double rho_slope = (p.x * d.x + p.z * d.z) * inverse;
  const double turn = (p.x * d.z - p.z * d.x) * inverse;
  const double r = torus.minor_radius;
  return {w * w + (p.y - r) * (p.y + r), 2 * (w * rho_slope + p.y * d.y),
          2 * (rho_slope * rho_slope + w * turn * turn * inverse + d.y * d.y)};
}

/// Finishes a root on the torus' own form. `s` lies near a root or near an extremum that is zero to
/// within the quartic's rounding error; `sign` is the quartic's sign just before it, `begin` where
/// that sign is known. Returns the crossing, or nothing when the line only comes near the surface.
std::optional<double> finish_root(const Torus& torus, const Vec3& origin, const Vec3& direction,
                                  double s, double sign, double begin);

}  // namespace rt
