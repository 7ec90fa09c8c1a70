// The arc tangent by arithmetic.
#include "rt/math/arctan.h"

#include <gtest/gtest.h>

#include "rt/math/rounding.h"
#include "unit/math/wide_lanes.h"

namespace rt {
namespace {

TEST(Arctan, IsTheLibrarysToAFewRoundings) {
  for (int i = -4000; i <= 4000; ++i) {
    for (const double scale : {1e-150, 1.0, 1e150}) {
      const double y = scale * 0.00071 * i;
      for (const double x : {-scale, -1e-3 * scale, 1e-12 * scale, 0.3 * scale, scale}) {
        const double truth = std::atan2(y, x);
        ASSERT_NEAR(arctan2(y, x), truth, gamma(6) * std::abs(truth)) << y << ' ' << x;
      }
    }
  }
}

TEST(Arctan, KeepsTheDigitsOfSmallAngles) {
  for (double y = 1e-300; y < 0.06; y *= 3.7) {
    EXPECT_NEAR(arctan2(y, 1.0) / std::atan(y), 1.0, gamma(4));
    EXPECT_NEAR(arctan2(-y, 1.0) / std::atan(-y), 1.0, gamma(4));
  }
}

TEST(Arctan, OfSeveralIsThatOfEach) {
  test::Arguments random(5);
  const std::vector<double> edges{0.0, 1.0, -1.0, std::numbers::sqrt2 - 1.0, 1e-300, -1e200};
  for (int k = 0; k < 20000; ++k) {
    const auto y = test::drawn([&] { return random.pick(edges, -1, 1); });
    const auto x = test::drawn([&] { return random.pick(edges, -1, 1); });
    const Wide angles = arctan2(test::packed(y), test::packed(x));
    for (std::size_t i = 0; i < lanes; ++i) {
      ASSERT_TRUE(test::same(angles[i], arctan2(y[i], x[i]))) << y[i] << ' ' << x[i];
    }
  }
}

TEST(Arctan, OnTheAxes) {
  EXPECT_EQ(arctan2(0.0, 0.0), 0.0);
  EXPECT_EQ(arctan2(0.0, 2.0), 0.0);
  EXPECT_EQ(arctan2(3.0, 0.0), std::numbers::pi / 2);
  EXPECT_EQ(arctan2(-3.0, 0.0), -std::numbers::pi / 2);
  EXPECT_EQ(arctan2(0.0, -1.0), std::numbers::pi);
}

}  // namespace
}  // namespace rt
