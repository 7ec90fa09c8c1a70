#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

const double apex = std::sqrt(26.0);

TEST(Blob, HasHeadBodyAndBase) {
  OptionalHit h = hit(Blob{}, {0, 3, 0}, {0, -1, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 2);
  EXPECT_EQ(h->feature, 0U);
  h = hit(Blob{}, {3, -0.5, 0}, {-1, 0, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_NEAR(h->t, 3 - (apex + 0.5) / 5, 1e-15);
  EXPECT_EQ(h->feature, 1U);
  h = hit(Blob{}, {0.5, -3, 0.5}, {0, 1, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 2);
  EXPECT_EQ(h->feature, 2U);
}

TEST(Blob, AxisRayGoesThroughBaseAndHead) {
  EXPECT_DOUBLE_EQ(t_of(Blob{}, {0, -3, 0}, {0, 1, 0}), 2);
  EXPECT_DOUBLE_EQ(t_of(Blob{}, {0, 0, 0}, {0, 1, 0}), 1);
  EXPECT_DOUBLE_EQ(t_of(Blob{}, {0, 0.5, 0}, {0, -1, 0}), 1.5);
}

TEST(Blob, IsSmoothAtTheJoin) {
  const double join = 1 / apex;
  const SurfacePoint above = point_of(Blob{}, {3, join + 1e-12, 0}, {-1, 0, 0});
  const SurfacePoint below = point_of(Blob{}, {3, join - 1e-12, 0}, {-1, 0, 0});
  expect_near(above.position, below.position, 3e-12);
  expect_near(above.normal, below.normal, 3e-12);
  const SurfacePoint at = point_of(Blob{}, {3, join, 0}, {-1, 0, 0});
  expect_near(at.position, {5 / apex, join, 0}, 2e-15);
}

TEST(Blob, RaysAlongItsSlopeGrazeOrMiss) {
  // Parallel to the generator in the plane z = 0, where the cone's quadratic loses its square.
  const Vec3 down(1, -5, 0);
  EXPECT_EQ(t_of(Blob{}, Vec3(5 / apex, 1 / apex, 0) - down + Vec3(1e-12, 0, 0), down), -1);
  EXPECT_GT(t_of(Blob{}, Vec3(5 / apex, 1 / apex, 0) - down - Vec3(1e-12, 0, 0), down), 0);
}

TEST(Blob, HasNothingAboveTheHead) {
  EXPECT_EQ(t_of(Blob{}, {3, apex, 0}, {-1, 0, 0}), -1);      // the cone's apex
  EXPECT_EQ(t_of(Blob{}, {3, apex + 1, 0}, {-1, 0, 0}), -1);  // its upper nappe
  EXPECT_EQ(t_of(Blob{}, {3, 1.01, 0}, {-1, 0, 0}), -1);
  EXPECT_EQ(t_of(Blob{}, {3, -1.01, 0}, {-1, 0, 0}), -1);
}

TEST(Blob, LeavingOutwardHitsNothingAndInwardTheOtherSide) {
  EXPECT_EQ(t_of(Blob{}, {0, 1, 0}, {1, 1e-9, 0}, leaving(Leaving::outward)), -1);
  EXPECT_DOUBLE_EQ(t_of(Blob{}, {0, 1, 0}, {0, -1, 0}, leaving(Leaving::inward, 0)), 2);
  EXPECT_DOUBLE_EQ(t_of(Blob{}, {0, -1, 0}, {0, 1, 0}, leaving(Leaving::inward, 2)), 2);
  const double rho = apex / 5;
  EXPECT_NEAR(t_of(Blob{}, {rho, 0, 0}, {-1, 0, 0}, leaving(Leaving::inward, 1)), 2 * rho, 1e-15);
  EXPECT_NEAR(t_of(Blob{}, {rho, 0, 0}, {-1, 2, 0}, leaving(Leaving::inward, 1)) * 2,
              surface_point(Blob{}, {{rho, 0, 0}, {-1, 2, 0}},
                            *hit(Blob{}, {rho, 0, 0}, {-1, 2, 0}, leaving(Leaving::inward, 1)))
                  .position.y,
              1e-15);
}

TEST(Blob, CoincidentStartCountsAsLeft) {
  EXPECT_EQ(t_of(Blob{}, {0, 1 - 1e-16, 0}, {0, 1, 0}, near_start(1e-15)), -1);
  EXPECT_DOUBLE_EQ(t_of(Blob{}, {0.1, -1, 0}, {0, 1, 0}, near_start(1e-15)),
                   1 + std::sqrt(1 - 0.01));
}

TEST(Blob, IsNeverHitByNan) {
  EXPECT_FALSE(hit(Blob{}, {0, nan, 0}, {0, -1, 0}).has_value());
  EXPECT_FALSE(hit(Blob{}, {0, 3, 0}, {nan, -1, 0}).has_value());
}

}  // namespace
}  // namespace rt::testing
