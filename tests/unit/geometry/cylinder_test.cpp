#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

TEST(Cylinder, IsMetOnSideAndDiscs) {
  OptionalHit h = hit(Cylinder{}, {3, 0.5, 0}, {-1, 0, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 2);
  EXPECT_EQ(h->feature, 0U);
  h = hit(Cylinder{}, {0.3, 3, 0.4}, {0, -2, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 1);
  EXPECT_EQ(h->feature, 2U);
  h = hit(Cylinder{}, {0.3, -3, 0.4}, {0, 1, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 3);
  EXPECT_EQ(h->feature, 1U);
}

TEST(Cylinder, IsLeftFromTheInside) {
  EXPECT_DOUBLE_EQ(t_of(Cylinder{}, {0, 0.5, 0}, {0, 0, 1}), 1);
  EXPECT_DOUBLE_EQ(t_of(Cylinder{}, {0, 0.25, 0}, {0, 1, 0}), 0.75);
}

TEST(Cylinder, ParallelToItsDiscs) {
  EXPECT_DOUBLE_EQ(t_of(Cylinder{}, {3, 1, 0}, {-1, 0, 0}), 2);  // in the top disc's plane
  EXPECT_DOUBLE_EQ(t_of(Cylinder{}, {3, 0, 0}, {-1, -0.0, 0}), 2);
  EXPECT_EQ(t_of(Cylinder{}, {3, std::nextafter(1.0, 2.0), 0}, {-1, 0, 0}), -1);
  EXPECT_EQ(t_of(Cylinder{}, {3, -1e-300, 0}, {-1, 0, 0}), -1);
}

TEST(Cylinder, ParallelToItsAxis) {
  EXPECT_DOUBLE_EQ(t_of(Cylinder{}, {1, 3, 0}, {0, -1, 0}), 2);
  EXPECT_EQ(t_of(Cylinder{}, {1.0000001, 3, 0}, {0, -1, 0}), -1);
  // Nearly parallel, through the bottom disc and out by the side.
  EXPECT_NEAR(t_of(Cylinder{}, {1 - 1e-12, -1, 0}, {1e-13, 1, 0}), 1, 1e-15);
}

TEST(Cylinder, RimIsNeitherGapNorDoubleHit) {
  // Down through the rim at (1, 1, 0): in by one feature, out by another, never in between.
  const OptionalHit h = hit(Cylinder{}, {2, 2, 0}, {-1, -1, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 1);
  const OptionalHit out =
      hit(Cylinder{}, {1, 1, 0}, {-1, -1, 0}, leaving(Leaving::inward, h->feature));
  ASSERT_TRUE(out.has_value());
  EXPECT_DOUBLE_EQ(out->t, 1);
  EXPECT_EQ(out->feature, 1U);
}

TEST(Cylinder, LeavingOutwardHitsNothingAndInwardTheOtherSide) {
  EXPECT_EQ(t_of(Cylinder{}, {1, 0.5, 0}, {1e-9, 1, 0}, leaving(Leaving::outward)), -1);
  EXPECT_DOUBLE_EQ(t_of(Cylinder{}, {1, 0.5, 0}, {-1, 0, 0}, leaving(Leaving::inward)), 2);
  EXPECT_NEAR(t_of(Cylinder{}, {1, 0.5, 0}, {-1e-9, 0, 1}, leaving(Leaving::inward)), 2e-9, 1e-24);
  EXPECT_DOUBLE_EQ(t_of(Cylinder{}, {0, 1, 0}, {0, -1, 0}, leaving(Leaving::inward, 2)), 1);
  EXPECT_DOUBLE_EQ(t_of(Cylinder{}, {0, 1, 0}, {1, -0.5, 0}, leaving(Leaving::inward, 2)), 1);
}

TEST(Cylinder, StackedDiscsCountAsLeft) {
  EXPECT_DOUBLE_EQ(t_of(Cylinder{}, {0, 1e-16, 0}, {0, 1, 0}, near_start(1e-15)), 1);
  EXPECT_EQ(t_of(Cylinder{}, {0, 1e-16, 0}, {0, -1, 0}, near_start(1e-15)), -1);
}

TEST(Cylinder, IsNeverHitByNan) {
  EXPECT_FALSE(hit(Cylinder{}, {3, nan, 0}, {-1, 0, 0}).has_value());
  EXPECT_FALSE(hit(Cylinder{}, {3, 0.5, 0}, {-1, 0, nan}).has_value());
}

}  // namespace
}  // namespace rt::testing
