#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

TEST(Box, MeetsEveryFaceAtItsPlane) {
  const Box box{{-1, -2, -3}, {1, 2, 3}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec3 origin(0.25);
      Vec3 direction(side > 0 ? -0.0 : 0.0);  // either zero in the other components
      origin[axis] = 10 * side;
      direction[axis] = -side;
      const OptionalHit h = hit(box, origin, direction);
      ASSERT_TRUE(h.has_value());
      EXPECT_DOUBLE_EQ(h->t, 10 - (axis + 1));
      EXPECT_EQ(h->feature, 2 * static_cast<std::uint32_t>(axis) + (side > 0));
      const SurfacePoint p = surface_point(box, {origin, direction}, *h);
      EXPECT_EQ(p.position[axis], side * (axis + 1));
      EXPECT_EQ(p.normal[axis], side);
    }
  }
}

TEST(Box, IsLeftFromTheInside) {
  EXPECT_DOUBLE_EQ(t_of(Box{}, {0.5, 0.5, 0.5}, {0, 0, 1}), 0.5);
  EXPECT_DOUBLE_EQ(t_of(Box{}, {0.5, 0.25, 0.5}, {-0.0, -1, 0}), 0.25);
}

TEST(Box, EdgesAndCornersBelongToIt) {
  // Through the edge x = 1, y = 1 and through the corner (1, 1, 1), exactly.
  EXPECT_DOUBLE_EQ(t_of(Box{}, {2, 0, 0.5}, {-1, 1, 0}), 1);
  EXPECT_DOUBLE_EQ(t_of(Box{}, {2, 1, 0}, {-1, 0, 1}), 1);
  EXPECT_DOUBLE_EQ(t_of(Box{}, {2, 0, 1.5}, {-1, 1, -0.5}), 1);
  // In the plane of a face, and just beside it.
  EXPECT_DOUBLE_EQ(t_of(Box{}, {2, 1, 0.5}, {-1, 0, -0.0}), 1);
  EXPECT_EQ(t_of(Box{}, {2, std::nextafter(1.0, 2.0), 0.5}, {-1, 0, 0}), -1);
}

TEST(Box, EdgesAreDecidedExactlyFromFarAway) {
  const double far = 0x1p27;
  // Past the edge x = 1, y = 1 by 2^-40, on either side: 2^-67 of the distance.
  EXPECT_GT(t_of(Box{}, {1 + far, 1 - far, 0.5}, {-1, 1 - 0x1p-67, 0}), 0);
  EXPECT_GT(t_of(Box{}, {1 + far, 1 - far + 0x1p-26, 0.5}, {-1, 1, 0}) + 2, 0);
  EXPECT_EQ(t_of(Box{}, {1 + far + 0x1p-25, 1 - far, 0.5}, {-1, 1, 0}), -1);
  EXPECT_GT(t_of(Box{}, {1 + far - 0x1p-25, 1 - far, 0.5}, {-1, 1, 0}), 0);
}

TEST(Box, IsNeverHitByNanOrByNothing) {
  EXPECT_FALSE(hit(Box{}, {nan, 0.5, 5}, {0, 0, -1}).has_value());
  EXPECT_FALSE(hit(Box{}, {0.5, 0.5, 5}, {0, nan, -1}).has_value());
  EXPECT_FALSE(hit(Box{}, {0.5, 0.5, 0.5}, {0, 0, 0}).has_value());
}

TEST(Box, LeavingOutwardHitsNothingAndInwardTheOtherSide) {
  EXPECT_FALSE(hit(Box{}, {1, 0.5, 0.5}, {1e-9, 1, 0}, leaving(Leaving::outward, 1)).has_value());
  const OptionalHit h = hit(Box{}, {1, 0.5, 0.5}, {-1, 0, 0}, leaving(Leaving::inward, 1));
  ASSERT_TRUE(h.has_value());
  EXPECT_DOUBLE_EQ(h->t, 1);
  EXPECT_EQ(h->feature, 0U);
  // Into the very edge: it comes out at once, but it does come out.
  const OptionalHit edge = hit(Box{}, {1, 1, 0.5}, {-1, 1, 0}, leaving(Leaving::inward, 1));
  ASSERT_TRUE(edge.has_value());
  EXPECT_GT(edge->t, 0);
  EXPECT_LT(edge->t, 1e-300);
  EXPECT_EQ(edge->feature, 3U);
}

TEST(Box, CoincidentFaceCountsAsLeft) {
  // A box that stands on a plane: rays leave the plane through the box' bottom.
  const Box box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_DOUBLE_EQ(t_of(box, {0.5, 1e-16, 0.5}, {0, 1, 0}, near_start(1e-15)), 1);
  EXPECT_EQ(t_of(box, {0.5, 1e-16, 0.5}, {0, -1, 0}, near_start(1e-15)), -1);
  EXPECT_NEAR(t_of(box, {-1, 1e-16, 0.5}, {1, 1e-3, 0}, near_start(1e-15)), 1, 1e-15);
}

}  // namespace
}  // namespace rt::testing
