#include "rt/geometry/image_bounds.h"

#include <gtest/gtest.h>

#include <random>

#include "stability/spots.h"

namespace rt::stability {
namespace {



Affine any_map(Random& random) {
  const Affine turned = Affine::rotation(0, random.uniform(0, 360)) *
                        Affine::rotation(1, random.uniform(0, 360)) *
                        Affine::rotation(2, random.uniform(0, 360));
  const Vec3 scales = random.below(2) == 0
                          ? Vec3(random.power_of_ten(-8, 8))
                          : Vec3(random.uniform(0.2, 3), -1.5, random.uniform(0.2, 3));
  return Affine::translation(10.0 * random.direction()) * turned * Affine::scaling(scales) *
         Affine::rotation(1, 33);
}

/// Of many points of the surface all lie within, and in each direction some come near.
void expect_close(const Shape& shape, Random& random) {
  for (int k = 0; k < 20; ++k) {
    const Affine map = any_map(random);
    const Bounds box = std::visit([&](const auto& s) { return image_bounds(map, s); }, shape);
    Bounds points;
    for (int i = 0; i < 20'000; ++i) {
      points.extend(map.point(spot_on(shape, random).position));
    }
    const double slack = 1e-14 * max_abs(map.offset);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_LE(box.lo[axis], points.lo[axis] + slack);
      ASSERT_GE(box.hi[axis], points.hi[axis] - slack);
      const double near = 0.05 * (box.hi[axis] - box.lo[axis]) + slack;
      ASSERT_NEAR(box.lo[axis], points.lo[axis], near);
      ASSERT_NEAR(box.hi[axis], points.hi[axis], near);
    }
  }
}

TEST(ImageBounds, HoldTheShapeAndLittleElse) {
  Random random(3);
  expect_close(Sphere{{0.3, -2, 1}, 0.7}, random);
  expect_close(Torus{1.0, 0.25}, random);
  expect_close(Torus{0.5, 0.8}, random);
  expect_close(Cylinder{}, random);
  expect_close(Capsule{1.5, 0.4}, random);
}

}  // namespace
}  // namespace rt::stability
