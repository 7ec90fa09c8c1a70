#include "rt/math/lobe.h"

#include <algorithm>
#include <cmath>

#include "rt/math/rounding.h"
#include "rt/math/warp.h"

namespace rt {
namespace {

/// Gamma(a + 1/2) / Gamma(a). The ratio at a + k follows from a asymptotic series in 1/a (Tricomi
/// and Erdelyi 1951; A&S 6.1.47 with a = 1/2, b = 0), whose first term left out is below 1e-16 from
/// 24 on, and the ratio at a from Gamma(a + 1) = a Gamma(a).
double gamma_ratio(double a) {
  double product = 1.0;
  while (a < 24.0) {
    product *= a / (a + 0.5);
    a += 1.0;
  }
  const double q = 1.0 / a;
  constexpr double c[] = {1.0,
                          -1.0 / 8,
                          1.0 / 128,
                          5.0 / 1024,
                          -21.0 / 32768,
                          -399.0 / 262144,
                          869.0 / 4194304,
                          39325.0 / 33554432,
                          -334477.0 / 2147483648.0};
  double series = 0.0;
  for (int i = 8; i >= 0; --i) {
    series = series * q + c[i];
  }
  return product * std::sqrt(a) * series;
}

/// The continued fraction of the incomplete beta function (DLMF 8.17.22), by Lentz's method:
/// I_x(a,b) = x^a (1-x)^b / (a B(a,b)) times this. Converges fast for x < (a+1)/(a+b+2).
double beta_fraction(double x, double a, double b) {
  double c = 1.0;
  double d = 1.0 / (1.0 - (a + b) * x / (a + 1.0));
  double value = d;
  for (int m = 1; m < 10000; ++m) {
    const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
    d = 1.0 / (1.0 + even * d);
    c = 1.0 + even / c;
    value *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    d = 1.0 / (1.0 + odd * d);
    c = 1.0 + odd / c;
    const double step = d * c;
    value *= step;
    if (std::abs(step - 1.0) < gamma(4)) {
      break;
    }
  }
  return value;
}

/// A basis about m whose x axis lies on the side of n; any where the two agree. Gives the sine of
/// their angle.
Frame frame_towards(const Vec3& m, const Vec3& n, double cos_theta, double& sin_theta) {
  Vec3 x = n - cos_theta * m;
  x -= glm::dot(x, m) * m;  // once more: the first difference carries roundings of n, not of x
  sin_theta = glm::length(x);
  if (sin_theta <= gamma(8)) {
    sin_theta = 0.0;
    return frame_about(m);
  }
  x /= sin_theta;
  return {x, glm::cross(m, x), m};
}

}  // namespace

PowerCosineLobe::PowerCosineLobe(double exponent) : exponent_(exponent) {
  const double a = 0.5 * (exponent + 1.0);
  beta_scale_ =
      gamma_ratio(a) / (a * std::sqrt(pi));  // B(a, 1/2) = Gamma(a) sqrt(pi) / Gamma(a+1/2)
}

// Let k be the unit vector along n x m, which lies in the horizon, lambda a direction's latitude
// towards k, and psi its longitude about k, counted from m and positive towards n. Then
// m.w = cos(lambda) cos(psi), n.w = cos(lambda) cos(psi - theta) and dw = cos(lambda) dlambda dpsi:
// the lobe separates, and the horizon cuts psi alone, at psi > theta - pi/2. With s = sin(psi),
//     1 - M = Prob(s < -cos theta),  s of density ~ (1 - s^2)^((e-1)/2),
//           = I_{sin^2 theta}((e+1)/2, 1/2) / 2,
// a regularised incomplete beta function; 0 at theta = 0 and 1/2 at theta = pi/2.
double PowerCosineLobe::mass_above(double cos_theta) const {
  const double y = std::min(1.0, cos_theta * cos_theta);  // 1 - sin^2
  const double x = 1.0 - y;
  const double a = 0.5 * (exponent_ + 1.0);
  // 1 - M is at most half of sin^(e+1), the raw mass outside the circle that touches the horizon,
  // and sin^(e+1) = (1-y)^a <= exp(-a y). exp(-37) is below the unit roundoff.
  if (a * y > 37.0) {
    return 1.0;
  }
  const double power = std::exp(a * std::log1p(-y));
  const double front = power * std::sqrt(y) * beta_scale_;
  const double below = x < (a + 1.0) / (a + 2.5) ? front * beta_fraction(x, a, 0.5)
                                                 : 1.0 - front * 2.0 * a * beta_fraction(y, 0.5, a);
  return 1.0 - 0.5 * below;
}

double PowerCosineLobe::pdf(const Vec3& w, const Vec3& m, const Vec3& n) const {
  const Vec3 apart = w - m;
  const double one_minus_cos = 0.5 * glm::dot(apart, apart);  // exact near the lobe's axis
  if (glm::dot(n, w) <= 0.0 || one_minus_cos >= 1.0) {
    return 0.0;
  }
  const double raw =
      (exponent_ + 1.0) / (2.0 * pi) * std::exp(exponent_ * std::log1p(-one_minus_cos));
  return raw / mass_above(std::max(0.0, glm::dot(m, n)));
}

// The angle alpha to m is drawn from the whole lobe: cos^(e+1) alpha = 1 - r^2 is uniform. Of the
// circle at alpha, with azimuth phi counted from the side of n, the part above the horizon is
//     sin(alpha) sin(theta) cos(phi) + cos(alpha) cos(theta) > 0,  i.e. |phi| < f pi,
//     f = acos(-cot(alpha) cot(theta)) / pi, or 1 where the circle clears the horizon,
// and phi is drawn uniformly there. The density drawn from is therefore p0 / f with p0 the lobe not
// renormalised; p = p0 / M, so the weight is f / M, and E[weight] = integral of p = 1. At grazing
// incidence, where it matters most, f and M both tend to 1/2 and the weight to 1.
PowerCosineLobe::Sample PowerCosineLobe::sample(const Vec2& u, const Vec3& m, const Vec3& n) const {
  const double cos_theta = std::max(0.0, glm::dot(m, n));
  const double mass = mass_above(cos_theta);
  const DiscPoint disc = disc_polar(u);
  if (!(disc.r > 0.0)) {
    return {m, 1.0 / mass};
  }
  const double log_cos = std::log1p(-disc.r * disc.r) / (exponent_ + 1.0);
  const double cos_alpha = std::exp(log_cos);
  const double sin_alpha = std::sqrt(-std::expm1(2.0 * log_cos));
  double sin_theta = 0.0;
  const Frame frame = frame_towards(m, n, cos_theta, sin_theta);
  const double across = sin_alpha * sin_theta;
  const double along = cos_alpha * cos_theta;
  double share = 1.0;
  Vec2 circle = disc.xy / disc.r;
  if (along < across) {  // the circle dips below the horizon
    share = std::acos(-along / across) / pi;
    circle = {std::cos(share * disc.phi), std::sin(share * disc.phi)};
  }
  Vec3 w = frame.to_world({sin_alpha * circle.x, sin_alpha * circle.y, cos_alpha});
  const double n_dot_w = glm::dot(n, w);
  if (n_dot_w < 0.0) {
    w -= 2.0 * n_dot_w * n;  // by rounding alone
  }
  return {w, share / mass};
}

}  // namespace rt
