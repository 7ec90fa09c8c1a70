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

/// The roots of y^2 + b y + c.
int quadratic_roots(double b, double c, double* roots) {
  const double discriminant = b * b - 4 * c;
  if (discriminant < 0) {
    return 0;
  }
  const double root = std::sqrt(discriminant);
  roots[0] = (-b - root) / 2;
  roots[1] = (-b + root) / 2;
  return 2;
}

}  // namespace

int depressed_ferrari(double p, double q, double r, double* roots) {
  // y^4 + p y^2 + q y + r = (y^2 + m y + k) (y^2 - m y + l), m^2 a root of the resolvent.
  const double m2 = largest_root(2 * p, p * p - 4 * r, -q * q);
  if (m2 > 0) {
    const double m = std::sqrt(m2);
    const int count = quadratic_roots(m, (p + m2 - q / m) / 2, roots);
    return count + quadratic_roots(-m, (p + m2 + q / m) / 2, roots + count);
  }
  const double discriminant = p * p - 4 * r;
  if (discriminant < 0) {
    return 0;
  }
  const double root = std::sqrt(discriminant);
  const int count = quadratic_roots(0, (p - root) / 2, roots);
  return count + quadratic_roots(0, (p + root) / 2, roots + count);
}

OptionalHit naive_ferrari(const Torus& torus, const Ray& ray) {
  const double R2 = torus.major_radius * torus.major_radius;
  const double r2 = torus.minor_radius * torus.minor_radius;
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double dd = glm::dot(d, d);
  const double od = glm::dot(o, d);
  const double k = glm::dot(o, o) - (R2 + r2);
  const double a4 = dd * dd;
  const double b = 4 * dd * od / a4;
  const double c = (2 * dd * k + 4 * od * od + 4 * R2 * d.y * d.y) / a4;
  const double e = (4 * k * od + 8 * R2 * o.y * d.y) / a4;
  const double f = (k * k - 4 * R2 * (r2 - o.y * o.y)) / a4;
  double roots[4];
  const int count =
      depressed_ferrari(c - 3 * b * b / 8, b * b * b / 8 - b * c / 2 + e,
                        -3 * b * b * b * b / 256 + b * b * c / 16 - b * e / 4 + f, roots);
  OptionalHit nearest;
  for (int i = 0; i < count; ++i) {
    const double t = roots[i] - b / 4;
    if (t > 0 && (!nearest || t < nearest->t)) {
      nearest = ShapeHit{t};
    }
  }
  return nearest;
}

}  // namespace rt::stability
