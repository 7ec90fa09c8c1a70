#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

TEST(Plane, IsMetFromBothSides) {
  EXPECT_DOUBLE_EQ(t_of(Plane{}, {1, 3, 2}, {0, -1, 0}), 3);
  EXPECT_DOUBLE_EQ(t_of(Plane{}, {1, -3, 2}, {0, 2, 5}), 1.5);
  EXPECT_EQ(t_of(Plane{}, {1, 3, 2}, {0, 1, 0}), -1);
  EXPECT_EQ(t_of(Plane{}, {1, 3, 2}, {1, 0, 0}), -1);
  EXPECT_EQ(t_of(Plane{}, {1, 3, 2}, {1, -0.0, 0}), -1);
  EXPECT_EQ(t_of(Plane{}, {1, 0, 2}, {1, 0, 0}), -1);
  EXPECT_EQ(t_of(Plane{}, {1, nan, 2}, {0, -1, 0}), -1);
}

TEST(Plane, IsMetAtGrazingAngles) {
  const SurfacePoint p = point_of(Plane{}, {0, 1, 0}, {1, -1e-9, 0});
  EXPECT_NEAR(p.position.x, 1e9, 1e-6);
  EXPECT_EQ(p.position.y, 0);
  EXPECT_EQ(p.normal.y, 1);
}

TEST(Plane, OnceLeftIsNotMetAgain) {
  EXPECT_FALSE(hit(Plane{}, {0, 1e-17, 0}, {1, -1e-20, 0}, leaving(Leaving::outward)).has_value());
  EXPECT_FALSE(hit(Plane{}, {0, 1e-17, 0}, {1, -1, 0}, near_start(1e-16)).has_value());
  EXPECT_TRUE(hit(Plane{}, {0, 1e-15, 0}, {1, -1, 0}, near_start(1e-16)).has_value());
}

TEST(Plane, IsUnbounded) {
  EXPECT_FALSE(bounds(Plane{}).finite());
  EXPECT_FALSE(bounds(Plane{}).empty());
}

TEST(Square, EndsAtItsEdges) {
  const Square square{2};
  EXPECT_DOUBLE_EQ(t_of(square, {1, 1, 1}, {0, -1, 0}), 1);
  EXPECT_EQ(t_of(square, {std::nextafter(1.0, 2.0), 1, 1}, {0, -1, 0}), -1);
  EXPECT_DOUBLE_EQ(t_of(square, {2, 1, 0}, {-1, -1, 0}), 1);
  EXPECT_EQ(t_of(square, {2 + 0x1p-51, 1, 0}, {-1, -1, 0}), -1);
}

TEST(Square, EdgesAreDecidedExactlyFromFarAway) {
  const double far = 0x1p27;
  EXPECT_GT(t_of(Square{2}, {1 + far, far, 0}, {-1, -1, 0}), 0);
  EXPECT_EQ(t_of(Square{2}, {1 + far + 0x1p-25, far, 0}, {-1, -1, 0}), -1);
  EXPECT_GT(t_of(Square{2}, {1 + far - 0x1p-25, far, 0}, {-1, -1, 0}), 0);
}

}  // namespace
}  // namespace rt::testing
