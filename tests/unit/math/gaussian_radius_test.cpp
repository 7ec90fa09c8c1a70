// The Gaussian filter's own logarithm, against the library's in more digits.
#include <gtest/gtest.h>

#include <cmath>

#include "rt/math/filter.h"
#include "rt/math/rounding.h"
#include "rt/math/warp.h"

namespace rt {
namespace {

using Long = long double;

/// From a point of the disc to the filter's offset lies a stretch by sigma sqrt(-2 log(1 - q)) / r,
/// q = r^2 mass.
void expect_stretch(const Vec2& u) {
  const Vec2 d = to_disc(u);
  const Vec2 offset = filter_offset(Filter::gaussian, u);
  const Long r2 = static_cast<Long>(d.x) * d.x + static_cast<Long>(d.y) * d.y;
  if (r2 == 0) {
    EXPECT_EQ(offset, Vec2(0.0));
    return;
  }
  const Long q = -std::expm1(Long{-4.5}) * r2;
  const Long log = -std::log1p(-q);
  const Long exact = 0.5L * std::sqrt(2 * log / r2);
  // q carries four roundings and the library's of the mass, which the logarithm amplifies by q /
  // ((1 - q) log) and the square root halves; beyond that one for the last sum and product of the
  // logarithm each, one for its series, quotient, root and product.
  const double condition = static_cast<double>(q / ((1 - q) * log));
  const double tolerance = gamma(6) + gamma(6) * condition / 2;
  const int axis = std::abs(d.x) > std::abs(d.y) ? 0 : 1;
  const Long ratio = static_cast<Long>(offset[axis]) / d[axis];
  EXPECT_LE(std::abs(ratio / exact - 1), Long{tolerance}) << u.x << ' ' << u.y;
}

TEST(GaussianRadius, IsTheLogarithmsToAFewRoundings) {
  constexpr int steps = 100000;
  for (int i = 0; i <= steps; ++i) {
    const double along = 0.5 + 0.5 * i / steps;
    expect_stretch({along, 0.5});
    expect_stretch({0.3, 1 - along});
  }
  for (int e = -50; e < -1; ++e) {
    expect_stretch({0.5 + std::ldexp(1.0, e), 0.5});
    expect_stretch({0.5, 0.5 - std::ldexp(0.9, e)});
    expect_stretch({std::ldexp(1.0, e), 0.5});  // the rim
  }
}

}  // namespace
}  // namespace rt
