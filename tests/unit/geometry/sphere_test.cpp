#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

TEST(Sphere, MeetsAnAxisRayAtUnitDistance) {
  EXPECT_DOUBLE_EQ(t_of(Sphere{}, {0, 0, 5}, {0, 0, -1}), 4);
  EXPECT_DOUBLE_EQ(t_of(Sphere{}, {0, 0, 5}, {0, 0, -2}), 2);
  EXPECT_EQ(t_of(Sphere{}, {0, 0, 5}, {0, 0, 1}), -1);
  EXPECT_EQ(t_of(Sphere{}, {0, 1.0001, 5}, {0, 0, -1}), -1);
}

TEST(Sphere, IsLeftFromTheInside) {
  EXPECT_DOUBLE_EQ(t_of(Sphere{}, {0, 0, 0}, {0, 0, 1}), 1);
  EXPECT_DOUBLE_EQ(t_of(Sphere{{1, 2, 3}, 2}, {1, 2, 3}, {0, -1, 0}), 2);
}

TEST(Sphere, RespectsTheRangeOfT) {
  const Ray ray{{0, 0, 5}, {0, 0, -1}};
  EXPECT_TRUE(intersect(Sphere{}, ray, 4.0, {}).has_value());
  EXPECT_FALSE(intersect(Sphere{}, ray, 3.999, {}).has_value());
}

TEST(Sphere, IsNeverHitByNanOrByNothing) {
  EXPECT_FALSE(hit(Sphere{}, {nan, 0, 5}, {0, 0, -1}).has_value());
  EXPECT_FALSE(hit(Sphere{}, {0, 0, 5}, {0, nan, -1}).has_value());
  EXPECT_FALSE(hit(Sphere{}, {0, 0, 5}, {0, 0, 0}).has_value());
  EXPECT_FALSE(hit(Sphere{}, {nan, 0, 0}, {0, 0, 1}, leaving(Leaving::inward)).has_value());
}

TEST(Sphere, LeavingOutwardHitsNothingAndInwardTheFarSide) {
  EXPECT_FALSE(hit(Sphere{}, {1, 0, 0}, {1, 1e-3, 0}, leaving(Leaving::outward)).has_value());
  EXPECT_DOUBLE_EQ(t_of(Sphere{}, {1, 0, 0}, {-1, 0, 0}, leaving(Leaving::inward)), 2);
  // A chord of 2e-9: the far root comes from the linear term, not from a difference.
  const double chord = t_of(Sphere{}, {1, 0, 0}, {-1e-9, 1, 0}, leaving(Leaving::inward));
  EXPECT_NEAR(chord, 2e-9, 1e-24);
}

TEST(Sphere, CoincidentStartCountsAsLeft) {
  EXPECT_FALSE(hit(Sphere{}, {1 - 1e-12, 0, 0}, {1, 0, 0}, near_start(1e-11)).has_value());
  EXPECT_NEAR(t_of(Sphere{}, {1 + 1e-12, 0, 0}, {-1, 0, 0}, near_start(1e-11)), 2, 1e-11);
  EXPECT_NEAR(t_of(Sphere{}, {1 + 1e-9, 0, 0}, {-1, 0, 0}, near_start(1e-11)), 1e-9, 1e-15);
}

TEST(Sphere, SeenFromFarAwayIsHitOnItsSurface) {
  for (const double distance : {1e4, 1e6, 2e7, 1e8}) {
    const SurfacePoint p =
        point_of(Sphere{}, {distance, 0.25 * distance, 0.5}, {-1, -0.25, -0.5 / distance});
    EXPECT_NEAR(glm::length(p.position), 1, 1e-15);
    EXPECT_NEAR(glm::length(p.normal), 1, 1e-15);
  }
}

TEST(Sphere, HoldsItsBounds) {
  const Bounds b = bounds(Sphere{{1, 2, 3}, 0.5});
  EXPECT_LE(b.lo.x, 0.5);
  EXPECT_GE(b.hi.z, 3.5);
  EXPECT_NEAR(b.hi.y, 2.5, 1e-14);
}

}  // namespace
}  // namespace rt::testing
