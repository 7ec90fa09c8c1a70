#include "stability/naive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt::stability {
namespace {

/// The largest real root of z^3 + a z^2 + b z + c, after Cardano and Viete.
double largest_root(double a, double b, double c) {
  const double q = (a * a - 3 * b) / 9;
  const double r = (2 * a * a * a - 9 * a * b + 27 * c) / 54;
  const double q3 = q * q * q;
  if (r * r < q3) {
    const double angle = std::acos(std::clamp(r / std::sqrt(q3), -1.0, 1.0));
    return -2 * std::sqrt(q) * std::cos((angle + 2 * std::numbers::pi) / 3) - a / 3;
  }
  const double u = -std::copysign(std::cbrt(std::abs(r) + std::sqrt(r * r - q3)), r);
  return u + (u != 0 ? q / u : 0) - a / 3;
}

/// The smaller positive root of t^2 + b t + c after a shift, kept if below `best`.
void keep_quadratic(double b, double c, double shift, double& best) {
  const double discriminant = b * b - 4 * c;
  if (discriminant < 0) {
    return;
  }
  const double root = std::sqrt(discriminant);
  for (const double t : {(-b - root) / 2 - shift, (-b + root) / 2 - shift}) {
    if (t > 0 && (best < 0 || t < best)) {
      best = t;
    }
  }
}

}  // namespace

double smallest_positive_ferrari(double a4, double a3, double a2, double a1, double a0) {
  const double b = a3 / a4;
  const double c = a2 / a4;
  const double d = a1 / a4;
  const double e = a0 / a4;
  const double p = c - 3 * b * b / 8;
  const double q = b * b * b / 8 - b * c / 2 + d;
  const double r = -3 * b * b * b * b / 256 + b * b * c / 16 - b * d / 4 + e;
  double best = -1;
  // y^4 + p y^2 + q y + r = (y^2 + m y + k) (y^2 - m y + l), m^2 a root of the resolvent.
  const double m2 = largest_root(2 * p, p * p - 4 * r, -q * q);
  if (m2 <= 0) {
    const double discriminant = p * p - 4 * r;
    if (discriminant >= 0) {
      keep_quadratic(0, (p - std::sqrt(discriminant)) / 2, b / 4, best);
      keep_quadratic(0, (p + std::sqrt(discriminant)) / 2, b / 4, best);
    }
    return best;
  }
  const double m = std::sqrt(m2);
  keep_quadratic(m, (p + m2 - q / m) / 2, b / 4, best);
  keep_quadratic(-m, (p + m2 + q / m) / 2, b / 4, best);
  return best;
}

OptionalHit naive_ferrari(const Torus& torus, const Ray& ray) {
  const double R2 = torus.major_radius * torus.major_radius;
  const double r2 = torus.minor_radius * torus.minor_radius;
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double dd = glm::dot(d, d);
  const double od = glm::dot(o, d);
  const double k = glm::dot(o, o) - (R2 + r2);
  const double t =
      smallest_positive_ferrari(dd * dd, 4 * dd * od, 2 * dd * k + 4 * od * od + 4 * R2 * d.y * d.y,
                                4 * k * od + 8 * R2 * o.y * d.y, k * k - 4 * R2 * (r2 - o.y * o.y));
  return t > 0 ? OptionalHit(ShapeHit{t}) : OptionalHit{};
}

}  // namespace rt::stability
