#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

const Capsule unit{1, 0.5};

TEST(Capsule, IsMetOnSideAndEnds) {
  OptionalHit h = hit(unit, {3, 0.5, 0}, {-1, 0, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 2.5);
  EXPECT_EQ(h->feature, 0U);
  h = hit(unit, {0, -3, 0}, {0, 1, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 2.5);
  EXPECT_EQ(h->feature, 1U);
  h = hit(unit, {0.3, 3, 0}, {0, -2, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 0.8);
  EXPECT_EQ(h->feature, 2U);
}

TEST(Capsule, IsLeftFromTheInside) {
  EXPECT_DOUBLE_EQ(t_of(unit, {0, 0.5, 0}, {0, 0, 1}), 0.5);
  EXPECT_DOUBLE_EQ(t_of(unit, {0, 0.25, 0}, {0, 1, 0}), 1.25);
  EXPECT_DOUBLE_EQ(t_of(unit, {0, -0.25, 0}, {0, -1, 0}), 0.25);
}

TEST(Capsule, HasNoSeamWhereItsPartsMeet) {
  for (const double y : {0.0, -0.0, 1.0}) {
    EXPECT_DOUBLE_EQ(t_of(unit, {3, y, 0}, {-1, 0, 0}), 2.5);
  }
  // Along the axis all is one chord.
  const OptionalHit in = hit(unit, {0, 4, 0}, {0, -1, 0});
  ASSERT_TRUE(in.has_value());
  const OptionalHit out = hit(unit, {0, 1.5, 0}, {0, -1, 0}, leaving(Leaving::inward, in->feature));
  ASSERT_TRUE(out.has_value());
  EXPECT_DOUBLE_EQ(out->t, 2);
  EXPECT_EQ(out->feature, 1U);
}

TEST(Capsule, IsMissedBesideItsEnds) {
  EXPECT_EQ(t_of(unit, {3, -0.5000001, 0}, {-1, 0, 0}), -1);
  EXPECT_EQ(t_of(unit, {3, 1.5000001, 0}, {-1, 0, 0}), -1);
  EXPECT_EQ(t_of(unit, {0.45, 3, 0.45}, {0, -1, 0}), -1);  // the corner of its box
}

TEST(Capsule, NormalsPointAwayFromTheCentreLine) {
  expect_near(point_of(unit, {3, 0.5, 0}, {-1, 0, 0}).normal, {1, 0, 0}, 0);
  expect_near(point_of(unit, {0.3, 3, 0}, {0, -1, 0}).normal, {0.6, 0.8, 0}, 1e-15);
  expect_near(point_of(unit, {0.3, -3, 0}, {0, 1, 0}).normal, {0.6, -0.8, 0}, 1e-15);
}

TEST(Capsule, LeavingOutwardHitsNothingAndInwardTheOtherSide) {
  EXPECT_EQ(t_of(unit, {0.5, 0.5, 0}, {1e-9, 1, 0}, leaving(Leaving::outward)), -1);
  EXPECT_DOUBLE_EQ(t_of(unit, {0.5, 0.5, 0}, {-1, 0, 0}, leaving(Leaving::inward)), 1);
  EXPECT_DOUBLE_EQ(t_of(unit, {0, -0.5, 0}, {0, 1, 0}, leaving(Leaving::inward, 1)), 2);
  EXPECT_DOUBLE_EQ(t_of(unit, {0, 1.5, 0}, {0, -1, 0}, leaving(Leaving::inward, 2)), 2);
}

TEST(Capsule, ATouchedSurfaceCountsAsLeft) {
  EXPECT_DOUBLE_EQ(t_of(unit, {0, -0.5 + 1e-16, 0}, {0, 1, 0}, near_start(1e-15)), 2);
  EXPECT_EQ(t_of(unit, {0, -0.5 + 1e-16, 0}, {0, -1, 0}, near_start(1e-15)), -1);
}

TEST(Capsule, IsNeverHitByNan) {
  EXPECT_FALSE(hit(unit, {3, nan, 0}, {-1, 0, 0}).has_value());
  EXPECT_FALSE(hit(unit, {3, 0.5, 0}, {-1, 0, nan}).has_value());
}

}  // namespace
}  // namespace rt::testing
