#include "rt/math/fresnel.h"

#include <algorithm>

namespace rt {

// Multiply numerator and denominator of rs by n1 c1 + n2 c2 and put in n2^2 c2^2 from Snell's law:
//     n1^2 c1^2 - n2^2 c2^2 = n1^2 - n2^2.
// The same for rp, with s1 = sin1:
//     n2^2 c1^2 - n1^2 c2^2 = (n2^2 - n1^2)(n2^2 c1^2 - n1^2 s1^2) / n2^2,
// which vanishes at Brewster's angle. What is left of subtraction is n2 - n1, exact for near
// indices (Sterbenz), and n2 c1 - n1 s1, small only where rp is negligible beside rs.
double fresnel(double cos_i, double n1, double n2) {
  if (n1 == n2) {
    return 0.0;
  }
  const double cos2_t = cos2_transmitted(cos_i, n1, n2);
  if (!(cos2_t > 0.0)) {
    return 1.0;
  }
  const double cos_t = std::sqrt(cos2_t);
  const double sin_i = std::sqrt(std::max(0.0, (1.0 - cos_i) * (1.0 + cos_i)));
  const double contrast = (n2 - n1) * (n2 + n1);
  const double s = n1 * cos_i + n2 * cos_t;
  const double p = n2 * (n2 * cos_i + n1 * cos_t);
  const double rs = contrast / (s * s);
  const double rp = contrast * (n2 * cos_i - n1 * sin_i) * (n2 * cos_i + n1 * sin_i) / (p * p);
  return std::min(1.0, 0.5 * (rs * rs + rp * rp));
}

Vec3 reflect(const Vec3& d, const Vec3& n) { return d - 2.0 * glm::dot(d, n) * n; }

std::optional<Vec3> refract(const Vec3& d, const Vec3& n, double n1, double n2) {
  const double cos_i = std::max(0.0, -glm::dot(d, n));
  const double cos2_t = cos2_transmitted(cos_i, n1, n2);
  if (!(cos2_t > 0.0) && n1 != n2) {
    return std::nullopt;
  }
  // Snell's law holds for the part along the surface; d + cos_i n is that part of d.
  const Vec3 t = n1 / n2 * (d + cos_i * n) - std::sqrt(cos2_t) * n;
  return t / glm::length(t);
}

}  // namespace rt
