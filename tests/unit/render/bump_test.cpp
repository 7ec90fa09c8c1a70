// Bumps and normal maps: tilted normals against closed forms, and no light where none can be.
#include <gtest/gtest.h>

#include "pictures.h"
#include "probe.h"
#include "rt/render/query.h"
#include "rt/render/surface_texture.h"

namespace rt {
namespace {

using test::add;
using test::bare_job;
using test::formula;
using test::matt;
using test::paint;

/// The tilted shading normal where a ray meets the scene.
Vec3 tilted(const RenderJob& job, const Vec3& origin, const Vec3& direction) {
  const RenderPlan plan = make_plan(job);
  const TraceRay ray{origin, glm::normalize(direction)};
  const auto hit = closest_hit(plan, ray);
  if (!hit) {
    ADD_FAILURE() << "the ray meets nothing";
    return Vec3(0.0);
  }
  ShadingPoint point = shading_point(plan, ray, *hit);
  const PlannedInstance& instance = plan.instances[hit->instance];
  textured(plan, ray, *hit, plan.material_of(instance), nullptr, point);
  return point.shading_normal;
}

void expect_direction(const Vec3& got, const Vec3& expected, double tolerance = 1e-8) {
  EXPECT_NEAR(glm::length(got), 1.0, 1e-12);
  EXPECT_LT(glm::length(got - glm::normalize(expected)), tolerance);
}

/// A height a u + b v: derivatives by differences are good to 1e-10.
Texture ramp(double a, double b) {
  return formula([=](const Vec2& uv) { return Rgb(5.0 + a * uv.x + b * uv.y); });
}

RenderJob with(const Shape& shape, const Affine& placed = {}) {
  RenderJob job = bare_job();
  add(job, shape, placed, matt(Rgb(0.5)));
  return job;
}

TEST(Bump, TiltsAPlaneAgainstTheRiseOfTheHeight) {
  // u = x, v = -z: the surface y = s (a x - b z) has the normal (-s a, 1, s b).
  RenderJob job = with(Plane{});
  paint(job, ramp(0.3, 0.7), TextureSlot::bump, 0.5);
  expect_direction(tilted(job, {0.2, 1, 0.3}, {0, -1, 0}), {-0.15, 1, 0.35});
  // From below the same surface is seen from its other side.
  expect_direction(tilted(job, {0.2, -1, 0.3}, {0, 1, 0}), {0.15, -1, -0.35});
}

TEST(Bump, IsOutwardWhateverTheHandednessOfTheCoordinates) {
  for (const bool mirrored : {false, true}) {
    auto data = std::make_shared<MeshData>();
    data->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    data->triangles = data->triangle_uvs = {{0, 1, 2}};
    data->uvs = mirrored ? std::vector<Vec2>{{1, 0}, {0, 0}, {1, 1}}
                         : std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}};
    RenderJob job = with(Mesh{data});
    paint(job, ramp(0.4, 0.2), TextureSlot::bump);
    expect_direction(tilted(job, {0.2, 0.3, 2}, {0, 0, -1}), {mirrored ? 0.4 : -0.4, -0.2, 1});
  }
}

TEST(Bump, OnASphereIsBlinnsFormula) {
  // At longitude 0 and latitude 0: dp_du = (0, 0, 2 pi), dp_dv = (0, pi, 0).
  RenderJob job = with(Sphere{});
  paint(job, ramp(0.6, 0.9), TextureSlot::bump);
  const double pi_ = std::numbers::pi;
  const Vec3 at = glm::normalize(Vec3(1, 1e-12, 1e-12));
  expect_direction(tilted(job, 3.0 * at, -at), {1, -0.9 / pi_, -0.6 / (2 * pi_)});
}

TEST(Bump, FollowsTheTransformOfItsNode) {
  // Raised in model space: the displaced surface y = s a x, scaled by (2, 3, 1), is y = 3 s a x
  // / 2.
  RenderJob job = with(Plane{}, Affine::scaling({2, 3, 1}));
  paint(job, ramp(0.4, 0), TextureSlot::bump);
  expect_direction(tilted(job, {0.2, 1, 0.3}, {0, -1, 0}), {-0.6, 1, 0});
}

TEST(Bump, OfNoiseIsItsGradientAlongTheSurface) {
  NoiseTexture noise;
  noise.octaves = {{2.0, 1.0}};
  noise.noise = std::make_shared<const Noise>();
  RenderJob job = with(Sphere{});
  paint(job, noise, TextureSlot::bump, 0.3);
  const Vec3 n = glm::normalize(Vec3(0.3, 0.5, 0.8));
  const Vec3 g = 0.5 * 2.0 * Noise().sample(2.0 * n).gradient;
  expect_direction(tilted(job, 3.0 * n, -n), n - 0.3 * (g - glm::dot(g, n) * n), 1e-12);
}

TEST(Bump, LetsNoNormalFaceAway) {
  RenderJob job = with(Plane{});
  paint(job, ramp(0, 50), TextureSlot::bump);
  for (const Vec3& d :
       {Vec3(0, -1, 0), Vec3(0.1, -0.2, 1), Vec3(0.1, -0.01, -1), Vec3(1, -1e-6, 0)}) {
    const Vec3 n = tilted(job, -d, d);
    EXPECT_GE(glm::dot(n, -glm::normalize(d)), -1e-12);
    EXPECT_NEAR(glm::length(n), 1.0, 1e-12);
  }
}

TEST(Bump, LeaksNoLightThroughTheSurface) {
  RenderJob job = with(Plane{});
  paint(job, ramp(3, 0), TextureSlot::bump);
  job.lights.push_back({.position = {-50, -1, 0}, .colour = Rgb(1.0)});  // below, on the steep side
  EXPECT_EQ(test::Probe(job)({0, 2, 0}, {-0.1, -1, 0}), Rgb(0.0));
  job.lights[0].position.y = 5;
  EXPECT_GT(test::Probe(job)({0, 2, 0}, {-0.1, -1, 0}).r, 0.1);
}

TEST(Bump, IsFlatAtAPoleAndFiniteAboutIt) {
  RenderJob job = with(Sphere{});
  paint(job, ramp(0.5, 0), TextureSlot::bump);
  expect_direction(tilted(job, {0, 3, 0}, {0, -1, 0}), {0, 1, 0});
  for (const double off : {1e-12, 1e-8, 1e-4}) {
    EXPECT_TRUE(all_finite(tilted(job, {off, 3, 0}, {0, -1, 0})));
  }
}

TEST(NormalMap, TiltsInTheTangentFrame) {
  const auto flat = [](const Rgb& c) { return formula([=](const Vec2&) { return c; }); };
  RenderJob job = with(Plane{});  // tangents x and -z
  paint(job, flat({0.5, 0.5, 1.0}), TextureSlot::normal);
  expect_direction(tilted(job, {0, 1, 0}, {0, -1, 0}), {0, 1, 0});
  paint(job, flat({0.8, 0.6, 0.9}), TextureSlot::normal);
  expect_direction(tilted(job, {0, 1, 0}, {0, -1, 0}), {0.6, 0.8, -0.2});
  paint(job, flat({0.8, 0.6, 0.9}), TextureSlot::normal, 0.5);
  expect_direction(tilted(job, {0, 1, 0}, {0, -1, 0}), {0.3, 0.8, -0.1});
  RenderJob ball = with(Sphere{});
  paint(ball, flat({0.8, 0.6, 0.9}), TextureSlot::normal);
  const Vec3 at = glm::normalize(Vec3(1, 1e-12, 1e-12));  // tangents z and y
  expect_direction(tilted(ball, 3.0 * at, -at), {0.8, 0.2, 0.6});
}

TEST(NormalMap, ThatPointsInwardStaysOutward) {
  RenderJob job = with(Plane{});
  paint(job, formula([](const Vec2&) { return Rgb(1.0, 0.5, 0.0); }), TextureSlot::normal);
  EXPECT_GT(tilted(job, {0, 1, 0}, {0, -1, 0}).y, 0.0);
}

}  // namespace
}  // namespace rt
