#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

const double root2 = std::sqrt(2.0);

TEST(Cone, IsMetOnSideAndDisc) {
  OptionalHit h = hit(PointedCone{}, {3, 0.5, 0}, {-1, 0, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 2.5);
  EXPECT_EQ(h->feature, 0U);
  h = hit(PointedCone{}, {0.3, -3, 0.4}, {0, 1, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 3);
  EXPECT_EQ(h->feature, 1U);
  h = hit(PointedCone{}, {0.3, 3, 0.4}, {0, -2, 0});
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 1.25);
  EXPECT_EQ(h->feature, 0U);
}

TEST(Cone, IsLeftFromTheInside) {
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0, 0.25, 0}, {0, 0, 1}), 0.75);
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0, 0.25, 0}, {0, 1, 0}), 0.75);
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0, 0.25, 0}, {0, -1, 0}), 0.25);
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0, 0.25, 0}, {1, 1, 0}), 0.375);
}

TEST(Cone, ItsApexIsMetOnTheAxis) {
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0, 3, 0}, {0, -1, 0}), 2);
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0, -3, 0}, {0, 1, 0}), 3);
  const SurfacePoint p = point_of(PointedCone{}, {0, 3, 0}, {0, -1, 0});
  EXPECT_NEAR(glm::length(p.normal), 1, 1e-15);
  EXPECT_NEAR(p.normal.y, root2 / 2, 1e-15);
}

TEST(Cone, HasNoUpperNappe) {
  EXPECT_EQ(t_of(PointedCone{}, {3, 1.5, 0}, {-1, 0, 0}), -1);
  EXPECT_EQ(t_of(PointedCone{}, {3, 1.0000001, 0}, {-1, 0, 0}), -1);
  EXPECT_EQ(t_of(PointedCone{}, {3, -1e-300, 0}, {-1, 0, 0}), -1);
  EXPECT_EQ(t_of(PointedCone{}, {0.5, 3, 0}, {-0.2, 1, 0}), -1);
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {3, 3, 0}, {-1, -1, 0}),
                   2.5);  // from above, across the side
}

TEST(Cone, RaysAlongItsSlopeGrazeOrMiss) {
  const Vec3 down(1, -1, 0);
  EXPECT_EQ(t_of(PointedCone{}, Vec3(-1 + 1e-12, 2, 0), down), -1);
  EXPECT_NEAR(t_of(PointedCone{}, Vec3(-1 - 0.5, 2, 0), down), 1.25, 1e-12);
}

TEST(Cone, TheNormalIsThatOfTheSlope) {
  const SurfacePoint p = point_of(PointedCone{}, {3, 0.5, 0}, {-1, 0, 0});
  expect_near(p.position, {0.5, 0.5, 0}, 1e-15);
  expect_near(p.normal, {root2 / 2, root2 / 2, 0}, 1e-15);
  expect_near(point_of(PointedCone{}, {0.1, -2, 0}, {0, 1, 0}).normal, {0, -1, 0}, 0);
}

// Along a generator, so that of the quadratic 4 to 5 digits are lost. t as twice the digits
// give it.
TEST(Cone, RaysInsideItComeOutNextToTheApex) {
  struct {
    Vec3 origin, direction;
    double t;
  } const cases[] = {
      {{0.12405023063519062, 0.86146983876671435, 0.06166154272053323},
       {-63.320370446760201, 70.707074508743815, -31.480792571026686},
       0.001959053279112115},
      {{-0.14186816387200452, 0.784040104559665, -0.16282536816527227},
       {4.6446122325266245e-05, 7.0709023169136467e-05, 5.331971270939978e-05},
       3053.6994213254784},
      {{-0.17214333991148578, 0.29913509413131578, -0.67939553045505363},
       {1.7353675711847301e-07, 7.0703190833236396e-07, 6.8555880457383042e-07},
       991048.21851436631},
      {{-0.66734444264068316, 0.20819867129739578, -0.42614638214070055},
       {5.9595753206049131e-09, 7.0709939061519893e-09, 3.805851701945084e-09},
       111975360.989434},
  };
  for (const auto& c : cases) {
    const OptionalHit h =
        intersect(PointedCone{}, {c.origin, c.direction}, 1e300, {Leaving::inward, 0, 1e-16});
    ASSERT_TRUE(h.has_value());
    // Off the side by no more than rounding moves the origin.
    EXPECT_NEAR(h->t * glm::length(c.direction), c.t * glm::length(c.direction), 1e-15);
  }
}

TEST(Cone, LeavingOutwardHitsNothingAndInwardTheOtherSide) {
  EXPECT_EQ(t_of(PointedCone{}, {0.5, 0.5, 0}, {1, 0, 0}, leaving(Leaving::outward)), -1);
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0.5, 0.5, 0}, {-1, 0, 0}, leaving(Leaving::inward)), 1);
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0.5, 0.5, 0}, {0, -1, 0}, leaving(Leaving::inward)), 0.5);
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0, 0, 0}, {0, 1, 0}, leaving(Leaving::inward, 1)), 1);
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0.5, 0, 0}, {0, 1, 0}, leaving(Leaving::inward, 1)), 0.5);
}

TEST(Cone, ADiscThatStandsOnAnotherCountsAsLeft) {
  EXPECT_DOUBLE_EQ(t_of(PointedCone{}, {0, 1e-16, 0}, {0, 1, 0}, near_start(1e-15)), 1);
  EXPECT_EQ(t_of(PointedCone{}, {0, 1e-16, 0}, {0, -1, 0}, near_start(1e-15)), -1);
}

TEST(Cone, IsNeverHitByNan) {
  EXPECT_FALSE(hit(PointedCone{}, {3, nan, 0}, {-1, 0, 0}).has_value());
  EXPECT_FALSE(hit(PointedCone{}, {3, 0.5, 0}, {-1, 0, nan}).has_value());
}

TEST(Cone, EveryRayThatEntersLeaves) {
  for (int i = 0; i < 2000; ++i) {
    const double angle = 0.37 * i;
    const Vec3 from(3 * std::cos(angle), 1.7 * std::sin(0.11 * i), 3 * std::sin(angle));
    const Vec3 to(0.4 * std::sin(0.7 * i), 0.3 + 0.2 * std::cos(1.3 * i), 0.2 * std::cos(0.3 * i));
    const OptionalHit in = hit(PointedCone{}, from, to - from);
    ASSERT_TRUE(in.has_value()) << i;
    const Ray ray{from, to - from};
    const SurfacePoint p = surface_point(PointedCone{}, ray, *in);
    ASSERT_LT(glm::dot(p.normal, ray.direction), 0) << i;
    const OptionalHit out =
        hit(PointedCone{}, p.position, ray.direction, leaving(Leaving::inward, in->feature));
    ASSERT_TRUE(out.has_value()) << i;
    const SurfacePoint q = surface_point(PointedCone{}, {p.position, ray.direction}, *out);
    EXPECT_GE(glm::dot(q.normal, ray.direction), -1e-12) << i;
    const double off_side = std::hypot(q.position.x, q.position.z) - (1 - q.position.y);
    EXPECT_LE(std::min(std::abs(off_side), std::abs(q.position.y)), 1e-13) << i;
  }
}

}  // namespace
}  // namespace rt::testing
