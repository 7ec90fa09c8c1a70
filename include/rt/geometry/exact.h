#pragma once
/// Error-free transformations, after Dekker (1971), Knuth (TAOCP 2, 4.2.2) and Jeannerod, Louvet &
/// Muller (2013). They hold as long as nothing overflows or becomes subnormal.
#include <cmath>

#include "rt/math/vec.h"

namespace rt {

/// An unevaluated sum high + low with |low| <= ulp(high) / 2.
struct DoublePair {
  double high;
  double low;
};

/// a - b, exactly.
inline DoublePair exact_difference(double a, double b) {
  const double high = a - b;
  const double b_part = a - high;
  const double a_part = high + b_part;
  return {high, (a - a_part) + (b_part - b)};
}

/// a * b, exactly.
inline DoublePair exact_product(double a, double b) {
  const double high = a * b;
  return {high, std::fma(a, b, -high)};
}

/// a * b - c * d to 1.5 ulp of the result, however much cancels (Kahan's algorithm).
inline double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

/// A number with the exact sign of a * b - c * d, and the exact negative of it when (a, b) and
/// (c, d) trade places. Rounding is monotonic, so two products that round apart are in that order.
inline double signed_difference(double a, double b, double c, double d) {
  const double ab = a * b;
  const double cd = c * d;
  return ab != cd ? ab - cd : std::fma(a, b, -ab) - std::fma(c, d, -cd);
}

/// origin + t * direction, each component rounded once.
inline Vec3 fused_at(const Vec3& origin, const Vec3& direction, double t) {
  return {std::fma(t, direction.x, origin.x), std::fma(t, direction.y, origin.y),
          std::fma(t, direction.z, origin.z)};
}

/// a x b, each component to 1.5 ulp.
inline Vec3 exact_cross(const Vec3& a, const Vec3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

}  // namespace rt
