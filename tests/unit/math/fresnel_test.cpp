#include "rt/math/fresnel.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "rt/math/warp.h"
#include "unit/math/chi_square.h"

namespace rt {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

double cos_degrees(double degrees) {
  const Real radians = Real(degrees) * boost::math::constants::pi<Real>() / 180;
  return static_cast<double>(Real(cos(radians)));
}

/// The textbook formula, in 50 digits.
double exact(double cos_i, double n1, double n2) {
  const Real c1 = cos_i;
  const Real s2 = Real(n1) * n1 / n2 / n2 * (1 - c1 * c1);
  if (s2 >= 1) {
    return 1.0;
  }
  const Real c2 = sqrt(1 - s2);
  const Real rs = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
  const Real rp = (n2 * c1 - n1 * c2) / (n2 * c1 + n1 * c2);
  return static_cast<double>(Real((rs * rs + rp * rp) / 2));
}

TEST(Fresnel, Table) {
  const struct {
    double degrees, n1, n2, seven_digits;
  } rows[] = {{0, 1, 1.5, 0.04},       {45, 1, 1.5, 0.0502399}, {60, 1, 1.5, 0.0891867},
              {89, 1, 1.5, 0.9041850}, {30, 1.5, 1, 0.0551902}, {45, 1.5, 1, 1.0},
              {90, 1, 1.5, 1.0}};
  for (const auto& row : rows) {
    const double c = row.degrees == 90 ? 0.0 : cos_degrees(row.degrees);
    EXPECT_NEAR(fresnel(c, row.n1, row.n2), row.seven_digits, 1e-7);
    EXPECT_NEAR(fresnel(c, row.n1, row.n2), exact(c, row.n1, row.n2), 1e-15);
  }
}

TEST(Fresnel, IsAccurateRelativelyForAnyIndices) {
  for (double n2 : {1.0 + 1e-15, 1.0 + 1e-9, 1.0003, 1.33, 1.5, 2.42, 40.0}) {
    for (int i = 0; i <= 1000; ++i) {
      const double c = i / 1000.0;
      EXPECT_NEAR(fresnel(c, 1.0, n2) / exact(c, 1.0, n2), 1.0, 1e-13) << n2 << " " << c;
      const double inside = exact(c, n2, 1.0);
      if (inside < 0.9) {  // towards the critical angle the error of cos_i takes over
        EXPECT_NEAR(fresnel(c, n2, 1.0) / inside, 1.0, 1e-12) << n2 << " " << c;
      }
    }
  }
}

TEST(Fresnel, IsReversible) {
  for (int i = 1; i <= 1000; ++i) {
    const double c1 = i / 1000.0;
    const double c2 = std::sqrt(cos2_transmitted(c1, 1.0, 1.5));
    // c2 is rounded, and dc1/dc2 ~ 1/c1.
    EXPECT_NEAR(fresnel(c1, 1.0, 1.5), fresnel(c2, 1.5, 1.0), 2e-15 * (2 + 1 / c1));
  }
}

TEST(Fresnel, EqualIndicesDoNothing) {
  const Vec3 d = glm::normalize(Vec3(1, -1e-9, 0));
  EXPECT_EQ(fresnel(0.0, 1.3, 1.3), 0.0);
  EXPECT_EQ(fresnel(0.7, 1.3, 1.3), 0.0);
  const auto t = refract(d, {0, 1, 0}, 1.3, 1.3);
  ASSERT_TRUE(t);
  EXPECT_LT(max_abs(*t - d), 1e-15);
  EXPECT_TRUE(refract({1, 0, 0}, {0, 1, 0}, 1.3, 1.3));
}

TEST(Refract, ObeysSnellAndKeepsUnitLength) {
  test::RandomPoints random(5);
  for (double eta : {0.25, 1 / 1.5, 1 - 1e-12, 1 + 1e-12, 1.33, 1.5, 4.0}) {
    for (int i = 0; i < 5000; ++i) {
      const Vec3 n = to_cone(random(), Cone{2.0});
      const Vec3 d = glm::normalize(-frame_about(n).to_world(to_cosine_hemisphere(random())));
      const double cos_i = -glm::dot(d, n);
      const auto t = refract(d, n, eta, 1.0);
      EXPECT_EQ(t.has_value(), fresnel(cos_i, eta, 1.0) < 1.0);
      if (!t) {
        continue;
      }
      EXPECT_NEAR(glm::length(*t), 1.0, 1e-15);
      EXPECT_LT(max_abs(eta * glm::cross(d, n) - glm::cross(*t, n)), 1e-14);
      EXPECT_LE(glm::dot(*t, n), 0.0);
    }
  }
}

// At the critical angle the transmitted ray grazes: cos_t^2 = (n1/n2)^2 (c^2 - c_crit^2). cos_t may
// err by the rounding of cos_i, magnified by d cos_t / d cos_i = eta^2 cos_i / cos_t.
TEST(Refract, IsAccurateNearTheCriticalAngle) {
  const Real critical = sqrt(1 - 1 / Real(2.25));
  for (double excess : {1e-14, 1e-12, 1e-9, 1e-6, 1e-3}) {
    const Real c = critical + excess;
    const Vec3 d{static_cast<double>(Real(sqrt(1 - c * c))), static_cast<double>(Real(-c)), 0};
    const auto t = refract(d, {0, 1, 0}, 1.5, 1.0);
    ASSERT_TRUE(t);
    const double exact_cos = static_cast<double>(Real(sqrt(1 - Real(2.25) * (1 - c * c))));
    EXPECT_NEAR(-t->y, exact_cos, 8 * 2.25 * 0x1p-53 / exact_cos) << excess;
    EXPECT_NEAR(glm::length(*t), 1.0, 1e-15);
    EXPECT_NEAR(t->x, 1.5 * d.x, 1e-14);
  }
  EXPECT_FALSE(refract({std::sqrt(1 - 0.745 * 0.745), -0.745, 0}, {0, 1, 0}, 1.5, 1.0));
}

TEST(Reflect, MirrorsExactly) {
  EXPECT_EQ(reflect({1, -1, 0}, {0, 1, 0}), Vec3(1, 1, 0));
  EXPECT_EQ(reflect({1, -1, 0}, {0, -1, 0}), Vec3(1, 1, 0));
}

}  // namespace
}  // namespace rt
