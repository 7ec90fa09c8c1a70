#include "torus_form.h"

#include <algorithm>

#include "rt/geometry/exact.h"

namespace rt {

/// Cauchy's iteration (the root of the osculating parabola, of third order), which converges on a
/// double root as fast as on a simple one and tells when there is none.
std::optional<double> finish_root(const Torus& torus, const Vec3& origin, const Vec3& direction,
                                  double s, double sign, double begin) {
  const double size = torus.major_radius + torus.minor_radius;
  const Vec3 near = fused_at(origin, direction, s);
  const double sheet = sheet_at(torus, std::sqrt(near.x * near.x + near.z * near.z), near.y);
  const double outward = sign * sheet;  // on the lemon the first factor is negative
  constexpr int most_steps = 12;        // three are the rule
  for (int i = 0; i < most_steps; ++i) {
    const FactorJet jet = factor_jet(torus, fused_at(origin, direction, s), direction, sheet);
    const double value = outward * jet.value;
    const double slope = outward * jet.slope;
    const double curvature = outward * jet.curvature;
    if (s <= begin && value > 0 && slope >= 0) {
      return std::nullopt;  // starts beside the surface and goes away from it
    }
    const double discriminant = slope * slope - 2 * value * curvature;
    if (!(discriminant >= 0)) {
      // The parabola stays clear of zero. Go to its vertex and look again, until the parabola's own
      // error there, of the order of curvature * step^3 / radius, is less than its clearance.
      const double step = -slope / curvature;
      const double clearance = -discriminant / (2 * curvature);
      if (clearance * torus.minor_radius > curvature * std::abs(step * step * step)) {
        return std::nullopt;
      }
      s += step;
      continue;
    }
    const double root = std::sqrt(discriminant);
    const double step = slope < 0 ? 2 * value / (root - slope) : -(slope + root) / curvature;
    s += step;
    // What a step leaves is of the order of step^3 / reach^2, reach being the distance over which
    // the parabola holds.
    const double reach = std::min(torus.minor_radius, root / std::abs(curvature));
    if (std::abs(step) <= 4 * unit_roundoff * size ||
        std::abs(step) * step * step <= unit_roundoff * size * reach * reach) {
      return s;
    }
  }
  return s;
}

}  // namespace rt
