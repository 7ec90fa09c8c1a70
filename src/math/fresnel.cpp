#include "rt/math/fresnel.h"

#include <algorithm>

#include "rt/math/wide_functions.h"

namespace rt {
namespace {

// Multiply numerator and denominator of rs by n1 c1 + n2 c2 and put in n2^2 c2^2 from Snell's law:
//     n1^2 c1^2 - n2^2 c2^2 = n1^2 - n2^2.
// The same for rp, with s1 = sin1:
//     n2^2 c1^2 - n1^2 c2^2 = (n2^2 - n1^2)(n2^2 c1^2 - n1^2 s1^2) / n2^2,
// which vanishes at Brewster's angle. What is left of subtraction is n2 - n1, exact for near
// indices (Sterbenz), and n2 c1 - n1 s1, small only where rp is negligible beside rs.
template <class Real>
Real partly_reflected(const Real& cos_i, const Real& n1, const Real& n2, const Real& cos2_t) {
  using std::max, std::min, std::sqrt;
  const Real cos_t = sqrt(cos2_t);
  const Real sin_i = sqrt(max(Real(0.0), (1.0 - cos_i) * (1.0 + cos_i)));
  const Real contrast = (n2 - n1) * (n2 + n1);
  const Real s = n1 * cos_i + n2 * cos_t;
  const Real p = n2 * (n2 * cos_i + n1 * cos_t);
  const Real rs = contrast / (s * s);
  const Real rp = contrast * (n2 * cos_i - n1 * sin_i) * (n2 * cos_i + n1 * sin_i) / (p * p);
  return min(Real(1.0), 0.5 * (rs * rs + rp * rp));
}

}  // namespace

double fresnel(double cos_i, double n1, double n2) {
  if (n1 == n2) {
    return 0.0;
  }
  const double cos2_t = cos2_transmitted(cos_i, n1, n2);
  return cos2_t > 0.0 ? partly_reflected(cos_i, n1, n2, cos2_t) : 1.0;
}

Wide fresnel(const Wide& cos_i, const Wide& n1, const Wide& n2) {
  const Wide cos2_t = cos2_transmitted(cos_i, n1, n2);
  return select(n1 == n2, Wide(0.0),
                select(cos2_t > 0.0, partly_reflected(cos_i, n1, n2, cos2_t), Wide(1.0)));
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

Wide3 refract(const Wide3& d, const Wide3& n, const Wide& n1, const Wide& n2, WideMask& through) {
  const Wide cos_i = max(Wide(0.0), -dot(d, n));
  const Wide cos2_t = cos2_transmitted(cos_i, n1, n2);
  through = cos2_t > 0.0 || n1 == n2;
  const Wide3 t = n1 / n2 * (d + cos_i * n) - sqrt(cos2_t) * n;
  return t / length(t);
}

}  // namespace rt
