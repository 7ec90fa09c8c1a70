#include <gtest/gtest.h>

#include "stability/families.h"
#include "stability/oracle_convex.h"
#include "stability/oracle_torus.h"

namespace rt::stability {
namespace {

TEST(Oracle, DoubleDoubleAgreesWithDecimal) {
  for (const Family& family : families("torus")) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
      const Case c = make_case(family, random);
      const Torus& torus = std::get<Torus>(c.shape);
      const auto fast = crossings(torus, Line<DoubleDouble>(c.ray, Vec3(0.0)), 0);
      const auto slow = crossings(torus, Line<Decimal>(c.ray, Vec3(0.0)), 0);
      ASSERT_EQ(fast.count, slow.count) << family.name();
      for (std::size_t k = 0; k < static_cast<std::size_t>(fast.count); ++k) {
        // Near a double root both are good to the root of their digits.
        EXPECT_NEAR(static_cast<double>(fast.s[k]), static_cast<double>(slow.s[k]), 1e-13);
      }
    }
  }
}

TEST(Oracle, KnowsTheClosedForms) {
  const Ray ray{{3, 0, 0}, {-1, 0, 0}};
  const auto torus = crossings(Torus{}, Line<Decimal>(ray, Vec3(0.0)), 0);
  ASSERT_EQ(torus.count, 4);
  const double expected[] = {-1.25, -0.75, 0.75, 1.25};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT(std::abs(static_cast<double>(torus.s[k] - Decimal(expected[k]))), 1e-40);
  }
  const auto sphere = crossings(Sphere{}, Line<Decimal>(ray, Vec3(0.0)), 0.5);
  ASSERT_EQ(sphere.count, 2);
  EXPECT_LT(std::abs(static_cast<double>(sphere.s[1] - Decimal(1.5))), 1e-40);
}

TEST(Oracle, DoubleDoubleHasThirtyDigits) {
  const DoubleDouble third = DoubleDouble(1) / 3;
  EXPECT_LT(std::abs(static_cast<double>(third * 3 - 1)), 1e-31);
  const DoubleDouble root = sqrt(DoubleDouble(2));
  EXPECT_LT(std::abs(static_cast<double>(root * root - 2)), 1e-31);
  EXPECT_EQ(static_cast<double>(DoubleDouble(1e16) + 1e-16 - 1e16), 1e-16);
}

}  // namespace
}  // namespace rt::stability
