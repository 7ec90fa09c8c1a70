// Normals in the world: of unit length, upright on the surface and towards the ray, on transforms
// that mirror, stretch and scale to the limits of what a double holds.
#include "rt/render/query.h"
#include "rt/render/shading.h"
#include "worlds.h"

namespace rt::test {
namespace {

std::vector<Affine> extreme_placements() {
  const Affine turned = Affine::rotation(1, 30) * Affine::rotation(0, 20);
  std::vector<Affine> out;
  for (const Vec3& scale : {Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(-1, -1, -1), Vec3(2, -3, 0.5),
                            Vec3(1e6, 1, 1), Vec3(1, 1e-6, 1), Vec3(1e3, -1e-3, 1), Vec3(1e-8),
                            Vec3(1e8), Vec3(-1e100, 1e100, 1e100), Vec3(1e-100, 1e-100, -1e-100)}) {
    out.push_back(turned * Affine::scaling(scale));
    out.push_back(Affine::scaling(scale) * turned);
  }
  return out;
}

std::vector<Shape> shapes() {
  auto data = std::make_shared<MeshData>();
  data->positions = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {0, 1.6, 0}};
  data->triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  return {Sphere{},   Box{{-0.7, -0.7, -0.7}, {0.7, 0.7, 0.7}},
          Cylinder{}, PointedCone{},
          Torus{},    Torus{0.5, 1},
          Blob{},     Plane{},
          Square{2},  Mesh{data}};
}

/// Checks the normal where a ray given in the model's space meets the placed shape.
bool check(const Shape& shape, const Affine& placed, const Ray& in_model) {
  World world({});
  world.job().camera.eye = placed.point(in_model.origin);
  world.add(shape, placed, matt(Rgb(0.5)));
  const RenderPlan plan = make_plan(world.job());
  const Vec3 direction = placed.vector(in_model.direction);
  const double largest =
      std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  const TraceRay ray{Vec3(0.0), glm::normalize(direction / largest)};
  const auto hit = closest_hit(plan, ray);
  if (!hit) {
    return false;
  }
  const ShadingPoint seen = shading_point(plan, ray, *hit);
  EXPECT_NEAR(glm::length(seen.normal), 1, 1e-14);
  EXPECT_LE(glm::dot(seen.normal, ray.direction), 1e-12);
  // The outward normal and the image of the model's own are on one side of the surface, however
  // mirrored; and the images of tangents lie in it.
  const SurfacePoint p = model_point(plan, ray, *hit);
  const double side = seen.side == Leaving::outward ? 1 : -1;
  // Turns of balls are left out of a plan.
  const Mat3 linear = plan.placement(plan.instances[hit->instance]).render_from_model.linear;
  if (!std::holds_alternative<Sphere>(shape)) {
    EXPECT_EQ(linear, placed.linear);
  }
  const auto image = [&](const Vec3& v) {
    const Vec3 w = linear * v;
    return glm::normalize(w / std::max({std::abs(w.x), std::abs(w.y), std::abs(w.z)}));
  };
  EXPECT_GT(side * glm::dot(seen.normal, image(p.normal)), 0);
  const SurfaceCoordinates c =
      std::visit([&](const auto& s) { return surface_coordinates(s, p, hit->feature); }, shape);
  for (const Vec3& tangent : {c.dp_du, c.dp_dv}) {
    if (glm::length(tangent) > 0) {
      // What the stretch does not shrink of the rounding of normal and tangent.
      EXPECT_NEAR(glm::dot(seen.normal, image(tangent)), 0, 1e-9);
    }
  }
  return true;
}

TEST(WorldNormals, AreUprightAndOfUnitLengthOnEveryTransform) {
  for (const Shape& shape : shapes()) {
    int hits = 0;
    for (const Affine& placed : extreme_placements()) {
      for (const Vec3& from : {Vec3(2, 1.5, 2.5), Vec3(-3, 0.4, 0.7), Vec3(0.3, 4, -1.1),
                               Vec3(0.9, -3, 0.2), Vec3(-0.5, 0.3, -4)}) {
        for (const Vec3& to : {Vec3(0.1, 0.3, -0.2), Vec3(0.7, 0.1, 0.4), Vec3(-0.9, 0.05, 0.3)}) {
          hits += check(shape, placed, {from, to - from}) ? 1 : 0;
        }
      }
    }
    EXPECT_GT(hits, 100) << shape_kind(shape);
  }
}

}  // namespace
}  // namespace rt::test
