#include "rt/math/transform.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rt/math/bounds.h"

namespace rt {
namespace {

TEST(Transform, RightAnglesAreExact) {
  for (int axis = 0; axis < 3; ++axis) {
    for (double turns : {-3.0, -1.0, 1.0, 2.0, 5.0}) {
      const Affine a = Affine::rotation(axis, 90.0 * turns);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const double e = a.linear[i][j];
          EXPECT_TRUE(e == 0.0 || std::abs(e) == 1.0) << axis << " " << turns;
        }
      }
    }
  }
}

TEST(Transform, RotationsAreRightHanded) {
  EXPECT_EQ(Affine::rotation(0, 90).vector({0, 1, 0}), Vec3(0, 0, 1));
  EXPECT_EQ(Affine::rotation(1, 90).vector({0, 0, 1}), Vec3(1, 0, 0));
  EXPECT_EQ(Affine::rotation(2, 90).vector({1, 0, 0}), Vec3(0, 1, 0));
}

TEST(Transform, ProductAppliesTheInnerMapFirst) {
  const Affine a = Affine::rotation(1, 90) * Affine::translation({0, 0, 2});
  EXPECT_EQ(a.point({0, 0, 0}), Vec3(2, 0, 0));
}

TEST(Transform, InverseUndoesAStretchOfAMillion) {
  const Affine a = Affine::translation({3, -2, 5}) * Affine::rotation(0, 33) *
                   Affine::scaling({1e6, 1, 1e-3}) * Affine::rotation(2, 71);
  const auto inv = inverse(a);
  ASSERT_TRUE(inv);
  const Vec3 p{0.3, -0.7, 0.9};
  // Each of the two maps errs by a few roundings of the largest term, which the other map
  // stretches.
  const double tolerance = 8 * norm(inv->linear) * norm(a.linear) * 0x1p-53;
  EXPECT_LT(max_abs(inv->point(a.point(p)) - p), tolerance);
}

TEST(Transform, SingularAndNonFiniteMapsHaveNoInverse) {
  EXPECT_FALSE(inverse(Affine::scaling({1, 0, 1})));
  EXPECT_FALSE(inverse(Affine::scaling({1, NAN, 1})));
  EXPECT_FALSE(inverse(Affine::translation({INFINITY, 0, 0})));
  EXPECT_FALSE(inverse(Affine::scaling({1e-320, 1e-320, 1})));
}

TEST(Bounds, TransformHoldsTheImagesOfCorners) {
  const Affine a =
      Affine::translation({1e6, 0, 0}) * Affine::rotation(1, 30) * Affine::scaling({1, -2, 3});
  const Bounds b{{-1, -1, -1}, {1, 1, 1}};
  const Bounds t = transformed(a, b);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = a.point({corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1});
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(p[k], t.lo[k]);
      EXPECT_LE(p[k], t.hi[k]);
    }
  }
}

}  // namespace
}  // namespace rt
