#include "torus_form.h"

#include <algorithm>

#include "rt/math/rounding.h"
#include "wide.h"

namespace rt {
namespace {

/// A factor along the line, with its first two derivatives, positive before the root.
struct Jet {
  double value, slope, curvature;
  /// Bounds a sixth of the third derivative. Only -2 R rho has one: rho'' is turn^2 / rho, so that
  /// |rho'''| <= 3 / rho^2.
  double twist;

  double discriminant() const { return slope * slope - 2 * value * curvature; }
};

/// `sign`: see finish_root. On the lemon the quartic and the second factor have opposite signs.
Jet jet_at(const TorusLine& line, double s, double sheet, double sign) {
  const Vec3 p = line.at(s);
  const Vec3& d = line.direction;
  const double r = line.torus.minor_radius;
  const double square = p.x * p.x + p.z * p.z;
  const double rho = std::sqrt(square);
  const double w = rho - sheet * line.torus.major_radius;
  const double inverse = square > 0 ? rho / square : 0;
  const double rho_slope = (p.x * d.x + p.z * d.z) * inverse;
  const double turn = (p.x * d.z - p.z * d.x) * inverse;
  const double scale = sign * sheet;
  return {scale * (w * w + (p.y - r) * (p.y + r)), scale * 2 * (w * rho_slope + p.y * d.y),
          scale * 2 * (rho_slope * rho_slope + w * turn * turn * inverse + d.y * d.y),
          line.torus.major_radius * inverse * inverse};
}

/// The jet's value in twice the digits: the quartic, of which only the other factor is rounded.
double wide_value(const TorusLine& line, double s, double sheet, double sign) {
  const Torus& torus = line.torus;
  const WidePoint p = wide_point(line.ray, line.line, s / line.length);
  const DoubleDouble R2 = squared(DoubleDouble(torus.major_radius));
  const DoubleDouble r2 = squared(DoubleDouble(torus.minor_radius));
  const DoubleDouble y2 = squared(p.y);
  const DoubleDouble square = squared(p.x) + y2 + squared(p.z);
  const auto quartic = static_cast<double>(squared(square - R2 - r2) + 4 * R2 * (y2 - r2));
  const Vec3 near = line.at(s);
  const double rho = std::sqrt(near.x * near.x + near.z * near.z);
  return sign * quartic / std::abs(factor(torus, rho, near.y, -sheet));
}

/// The decision at an extremum that is zero to within rounding. Its place need only be known to
/// the root of the accuracy asked for.
std::optional<double> finish_double_root(const TorusLine& line, double s, double sheet, double sign,
                                         double begin) {
  Jet jet = jet_at(line, s, sheet, sign);
  for (int i = 0; i < 2; ++i) {
    s -= jet.slope / jet.curvature;
    jet = jet_at(line, s, sheet, sign);
  }
  const double value = wide_value(line, s, sheet, sign);
  if (s <= begin || !(value <= 0)) {
    return std::nullopt;
  }
  return s - std::sqrt(-2 * value / jet.curvature);
}

double sheet_near(const TorusLine& line, double s) {
  const Vec3 p = line.at(s);
  return sheet_at(line.torus, std::sqrt(p.x * p.x + p.z * p.z), p.y);
}

/// The lowest point of the jet's parabola, and how wrong the parabola may be there.
struct Vertex {
  double step, height, doubt;
};

Vertex vertex_of(const Jet& jet, double discriminant) {
  const double step = -jet.slope / jet.curvature;
  return {step, -discriminant / (2 * jet.curvature), 2 * jet.twist * std::abs(step * step * step)};
}

/// A step to the parabola's root (Cauchy's iteration, of third order, which converges on a double
/// root as fast as on a simple one), or where the root is clearly simple Halley's, its cheaper
/// like. `settled`: what it leaves is below `exact`. That is the third derivative's part, and in
/// Halley's case the parabola's higher-order part, both over the slope at the root.
struct Step {
  double length;
  bool settled;
};

Step step_to_root(const Jet& jet, double discriminant, double exact) {
  const double square = jet.slope * jet.slope;
  const double bend = jet.value * jet.curvature;
  double step;
  double root = -jet.slope;
  if (jet.slope < 0 && 8 * std::abs(bend) < square) {
    step = -jet.value * jet.slope / (square - 0.5 * bend);
  } else {
    root = std::sqrt(discriminant);
    step = jet.slope < 0 ? 2 * jet.value / (root - jet.slope) : -(jet.slope + root) / jet.curvature;
  }
  const double cube = std::abs(step) * step * step;
  return {step, std::abs(step) <= 4 * exact ||
                    (cube * jet.twist <= exact * root &&
                     cube * jet.curvature * jet.curvature <= exact * root * root)};
}

}  // namespace

std::optional<double> finish_root(const TorusLine& line, double s, double sign, double begin) {
  const Torus& torus = line.torus;
  const double sheet = torus.minor_radius < torus.major_radius ? 1 : sheet_near(line, s);
  // A factor's rounding error: |w|, |y| and r are at most r at the surface, and each takes the
  // rounding of something of the torus' size a few times.
  const double noise = gamma(32) * line.size() * torus.minor_radius;
  constexpr int most_steps = 12;  // one or two are the rule
  for (int i = 0; i < most_steps; ++i) {
    const Jet jet = jet_at(line, s, sheet, sign);
    if (s <= begin && jet.value > 0 && jet.slope >= 0) {
      return std::nullopt;  // starts beside the surface and goes away from it
    }
    const double discriminant = jet.discriminant();
    if (discriminant <= 2 * noise * jet.curvature) {
      const Vertex vertex = vertex_of(jet, discriminant);
      if (std::abs(vertex.height) <= noise && vertex.doubt <= noise) {
        return finish_double_root(line, s, sheet, sign, begin);
      }
      if (vertex.height > vertex.doubt) {
        return std::nullopt;
      }
      if (discriminant < 0) {
        s += vertex.step;
        continue;
      }
    }
    if (discriminant < 0) {
      // Concave and below zero all about: the root has been passed. Where three roots nearly
      // coincide rounding does that.
      if (std::abs(jet.value) <= noise) {
        return s;
      }
      s -= jet.slope < 0 ? jet.value / jet.slope : std::sqrt(2 * jet.value / jet.curvature);
      continue;
    }
    const Step step = step_to_root(jet, discriminant, unit_roundoff * line.size());
    if (!(std::abs(step.length) <= line.size())) {
      return s;  // flat to within rounding: the crossing is here as much as anywhere near
    }
    s += step.length;
    if (step.settled) {
      return s;
    }
  }
  return s;
}

}  // namespace rt
