#include "rt/math/warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "unit/math/chi_square.h"

namespace rt {
namespace {

using namespace test;

// Each p-value below is uniform in [0,1] for a right sampler; with some 20 tests in this folder,
// one below 0.01 / 20 would be found by chance in one code out of a hundred. Seeds are fixed.
constexpr double alpha = 0.01 / 20;

TEST(Warp, FramesAreOrthonormalAndRightHanded) {
  RandomPoints random(1);
  for (int i = 0; i < 2000; ++i) {
    Vec3 z = to_cone(random(), Cone{2.0});
    if (i < 4) {
      z = {0, 0, i % 2 ? 1.0 : -1.0};
    } else if (i < 200) {
      z = glm::normalize(Vec3(z.x * 1e-9, z.y * 1e-12, i % 2 ? 1.0 : -1.0));
    }
    const Frame f = frame_about(z);
    EXPECT_LT(max_abs(glm::cross(f.x, f.y) - z), 1e-15);
    EXPECT_LT(std::abs(glm::dot(f.x, f.y)), 1e-15);
    EXPECT_LT(std::abs(glm::dot(f.x, f.x) - 1.0), 1e-15);
  }
}

TEST(Warp, DiscIsUniform) {
  const Grid grid{-1, 1, -1, 1, 16, 16};
  const auto pdf = [](double x, double y) { return x * x + y * y < 1 ? disc_pdf : 0.0; };
  EXPECT_GT(density_p(grid, to_disc, pdf, 200000, 1, 128), alpha);
}

TEST(Warp, DiscPolarAgreesWithCartesian) {
  RandomPoints random(2);
  for (int i = 0; i < 10000; ++i) {
    const DiscPoint p = disc_polar(random());
    EXPECT_NEAR(p.r * std::cos(p.phi), p.xy.x, 4e-16);
    EXPECT_NEAR(p.r * std::sin(p.phi), p.xy.y, 4e-16);
    EXPECT_LT(p.r, 1.0);
  }
  EXPECT_EQ(to_disc({0.5, 0.5}), Vec2(0, 0));
}

TEST(Warp, CosineHemisphereHasItsDensity) {
  const auto draw = [](Vec2 u) { return cylinder_of(to_cosine_hemisphere(u)); };
  const auto pdf = [](double z, double) { return cosine_hemisphere_pdf(z); };
  EXPECT_GT(density_p(sphere_grid(16, 16), draw, pdf, 200000), alpha);
}

TEST(Warp, ConesAreUniform) {
  for (double h : {2.0, 1.9999, 1.0, 0.3, 1e-4, 1e-16}) {
    const Cone cone{h};
    // The direction's offset from the axis relative to the cone's height, for h below rounding
    // of 1.
    const auto draw = [&](Vec2 u) {
      const Vec3 w = to_cone(u, cone);
      const double across = w.x * w.x + w.y * w.y;
      const double height = w.z > 0 ? across / (1.0 + w.z) : 1.0 - w.z;
      return Vec2(height / h, std::atan2(w.y, w.x));
    };
    const Grid grid{0, 1 + 1e-12, -pi, pi + 1e-12, 16, 16};
    EXPECT_GT(density_p(
                  grid, draw, [](double, double) { return 0.5 / pi; }, 100000),
              alpha)
        << h;
    EXPECT_NEAR(cone.pdf() * cone.solid_angle(), 1.0, 1e-15);
  }
}

TEST(Warp, TinyAndFullConesStayUnitAndInside) {
  RandomPoints random(3);
  for (double sine : {1e-8, 1e-5, 1e-2, 0.9, 1.0}) {
    const Cone cone = Cone::from_sin2(sine * sine);
    const double half = std::sin(0.5 * std::asin(sine));
    EXPECT_NEAR(cone.solid_angle() / (4 * pi * half * half), 1.0, 1e-15);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 w = to_cone(random(), cone);
      EXPECT_NEAR(glm::dot(w, w), 1.0, 1e-15);
      EXPECT_LE(std::hypot(w.x, w.y), sine * (1 + 1e-15));
    }
  }
  // 2 pi (1 - cos) = pi sin^2 (1 + sin^2/4 + ...): the solid angle of a cone of 1e-8.
  EXPECT_NEAR(Cone::from_sin2(1e-16).solid_angle(), pi * 1e-16, 1e-30);
}

// The point drawn lies on the sphere, in front, and sees nothing of the sphere before it.
TEST(Warp, SphereSamplesLieOnTheNearSide) {
  RandomPoints random(4);
  const Vec3 centre{3, -2, 7};
  for (double d : {1.0 + 1e-9, 1.001, 2.0, 1e4, 1e8}) {
    for (int i = 0; i < 1000; ++i) {
      const Vec3 towards = to_cone(random(), Cone{2.0});
      const Vec3 p = centre - d * 2.5 * towards;
      const auto s = sample_sphere(random(), p, centre, 2.5);
      ASSERT_TRUE(s);
      EXPECT_NEAR(glm::length(s->direction), 1.0, 1e-15);
      // Relative to p, whose rounding is that of d.
      const Vec3 q = (p - centre) + s->distance * s->direction;
      EXPECT_NEAR(glm::length(q) / 2.5, 1.0, 1e-15 * (4 * d + 8));
      EXPECT_LE(glm::dot(q, s->direction), 2.5 * 1e-15 * (4 * d + 8));
    }
  }
  EXPECT_FALSE(sample_sphere({0.5, 0.5}, centre, centre, 2.5));
  EXPECT_FALSE(sample_sphere({0.5, 0.5}, centre + Vec3(0, 2.5, 0), centre, 2.5));
}

TEST(Warp, SphereSolidAngleIsTheClosedForm) {
  for (double d : {1.0000001, 1.5, 10.0, 1e6}) {
    const auto s = sample_sphere({0.3, 0.4}, {0, 0, 0}, {0, d, 0}, 1.0);
    const long double ratio = 1.0L / d;
    const long double exact =
        2 * std::numbers::pi_v<long double> * (1 - std::sqrt(1 - ratio * ratio));
    // The reference cancels, with 64 bits, for large d.
    EXPECT_NEAR(s->pdf * static_cast<double>(exact), 1.0, 1e-15 + 1e-18 * d * d) << d;
  }
}

}  // namespace
}  // namespace rt
