#include <random>

#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

/// Transforms that a scene may place a shape with: mirrored, and stretched up to 1e6 : 1.
std::vector<Affine> placements() {
  std::vector<Affine> out;
  out.push_back(Affine::scaling({-1, 1, 1}));
  out.push_back(Affine::translation({1, -2, 3}) * Affine::rotation(1, 30) *
                Affine::scaling({2, -3, 0.5}));
  out.push_back(Affine::rotation(0, 45) * Affine::scaling({1e6, 1, 1}));
  out.push_back(Affine::rotation(2, 45) * Affine::scaling({1, 1e-6, 1}));
  out.push_back(Affine::scaling({1e-8, 1e-8, 1e-8}));
  out.push_back(Affine::scaling({1e8, 1e8, 1e8}));
  return out;
}

/// A ray that meets the shape in model space meets it at the same t when it is carried to the world
/// and back: t is a property of the ray, not of a space.
template <class S>
void check_placements(const S& shape) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Affine& world_from_model : placements()) {
    const Affine model_from_world = *inverse(world_from_model);
    for (int i = 0; i < 200; ++i) {
      const Vec3 origin = 4.0 * Vec3(uniform(random), uniform(random), uniform(random));
      const Vec3 target = 0.4 * Vec3(uniform(random), uniform(random), uniform(random));
      const Ray model{origin, target - origin};
      const Ray back{model_from_world.point(world_from_model.point(model.origin)),
                     model_from_world.vector(world_from_model.vector(model.direction))};
      const OptionalHit direct = intersect(shape, model, infinity, {});
      const OptionalHit carried = intersect(shape, back, infinity, {});
      if (!direct || !carried) {
        continue;  // edges: the stability suite counts those
      }
      const SurfacePoint a = surface_point(shape, model, *direct);
      if (std::abs(glm::dot(a.normal, glm::normalize(model.direction))) < 1e-2) {
        continue;
      }
      // A stretch of 1e6 loses six digits of the ray, of whose ten left grazing takes two.
      EXPECT_NEAR(direct->t, carried->t, 1e-7);
      const SurfacePoint b = surface_point(shape, back, *carried);
      EXPECT_NEAR(glm::length(b.normal), 1, 1e-14);
      EXPECT_GT(glm::dot(a.normal, b.normal), 0.999);
    }
  }
}

TEST(Transformed, EveryShapeKeepsItsHits) {
  check_placements(Sphere{});
  check_placements(Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
  check_placements(Plane{});
  check_placements(Square{3});
  check_placements(Cylinder{});
  check_placements(PointedCone{});
  check_placements(Torus{});
  check_placements(Torus{0.5, 1});
  check_placements(Blob{});
  check_placements(Capsule{});
}

TEST(Transformed, MirroredSphereIsHitAtItsMirroredPlace) {
  const Affine world = Affine::translation({5, 0, 0}) * Affine::scaling({-2, 1, 1});
  const Affine model = *inverse(world);
  const Ray ray{{5, 0, 9}, {0, 0, -1}};
  const Ray inner{model.point(ray.origin), model.vector(ray.direction)};
  EXPECT_DOUBLE_EQ(t_of(Sphere{}, inner.origin, inner.direction), 8);
  const Ray from_side{{9, 0, 0}, {-1, 0, 0}};
  EXPECT_DOUBLE_EQ(t_of(Sphere{}, model.point(from_side.origin), model.vector(from_side.direction)),
                   2);
}

TEST(Shape, KindsAreTheScriptsNames) {
  EXPECT_STREQ(shape_kind(Sphere{}), "sphere");
  EXPECT_STREQ(shape_kind(Torus{}), "torus");
  EXPECT_STREQ(shape_kind(Square{}), "square");
  EXPECT_STREQ(shape_kind(Capsule{}), "capsule");
}

}  // namespace
}  // namespace rt::testing
