// What --disable takes away, and what is not left to chance.
#include <gtest/gtest.h>

#include <limits>

#include "probe.h"

namespace rt {
namespace {

using test::add;
using test::glass;
using test::matt;

/// Everything that can be switched off, in one picture. The hook edits the materials as they are.
template <class Edit>
RenderJob scene(Edit edit) {
  RenderJob job = test::job_looking({0, 2, 8}, {0, 0.6, 0}, 48, 36);
  const auto put = [&](const Shape& shape, const Affine& place, Material m) {
    edit(m);
    add(job, shape, place, m);
  };
  Material clear = glass(1.5);
  clear.ks = Rgb(0.5);
  clear.shininess = 50;
  Material milky = glass(1.3);
  milky.kd = {0.6, 0.2, 0.2};
  milky.opacity = 0.5;
  milky.glossiness = 0.2;
  milky.absorption = {0.1, 0.5, 0.2};
  Material mirror = matt(Rgb(0.1));
  mirror.reflectivity = Rgb(0.7);
  Material brushed = mirror;
  brushed.glossiness = 0.3;
  put(Plane{}, {}, matt(Rgb(0.7)));
  put(Sphere{{-1.8, 0.8, 0}, 0.8}, {}, clear);
  put(Sphere{{0, 0.8, 0}, 0.8}, {}, milky);
  put(Sphere{{1.8, 0.8, 0}, 0.8}, {}, brushed);
  put(Box{{-1, 0, -3}, {1, 2, -2.5}}, {}, mirror);
  job.lights.push_back({.position = {3, 5, 4}, .colour = Rgb(0.6), .radius = 0.7});
  job.lights.push_back(
      {.position = {-3, 5, 2}, .colour = Rgb(0.4), .rectangle = {{{1, 0, 0}, {0, 0, 1}}}});
  job.ambient = Rgb(0.2);
  job.options.background = {{0.3, 0.4, 0.7}, {0.8, 0.8, 0.8}};
  job.options.samples = 2;
  return job;
}

RenderJob scene() {
  return scene([](Material&) {});
}

std::vector<float> picture(const RenderJob& job) { return test::rendered(job).film.pixels; }

TEST(Disable, RefractionMakesGlassOpaque) {
  RenderJob off = scene();
  off.options.refraction = false;
  EXPECT_NE(picture(off), picture(scene()));
  EXPECT_EQ(picture(off), picture(scene([](Material& m) { m.opacity = 1.0; })));
}

TEST(Disable, GlossyMakesMirrorsPerfect) {
  RenderJob off = scene();
  off.options.glossy = false;
  EXPECT_NE(picture(off), picture(scene()));
  EXPECT_EQ(picture(off), picture(scene([](Material& m) { m.glossiness = 0.0; })));
}

TEST(Disable, SoftShadowsMakesLightsPoints) {
  RenderJob off = scene();
  off.options.soft_shadows = false;
  RenderJob points = scene();
  for (Light& light : points.lights) {
    light.radius = 0.0;
    light.rectangle.reset();
  }
  EXPECT_NE(picture(off), picture(scene()));
  EXPECT_EQ(picture(off), picture(points));
  EXPECT_EQ(test::rendered(off).statistics.rays.shadow,
            test::rendered(points).statistics.rays.shadow);
}

TEST(Disable, ReflectionLeavesTheTransmittedShareAlone) {
  RenderJob off = scene();
  off.options.reflection = false;
  const RenderResult result = test::rendered(off);
  EXPECT_EQ(result.statistics.rays.reflection, 0u);
  // A pane, straight through: no series of inner reflections, nothing gained for those lost.
  RenderJob pane = test::bare_job();
  pane.options.reflection = false;
  pane.options.background = {Rgb(1.0), Rgb(1.0)};
  add(pane, Box{{-1, -1, -3}, {1, 1, -2}}, {}, glass(1.5));
  EXPECT_NEAR(test::Probe(pane)({0, 0, 0}, {0, 0, -1}).r, 0.96 * 0.96, 1e-15);
}

TEST(Chance, HasNoPartInASceneWithoutNeed) {
  // No area light, no gloss: glass, mirrors and media take no random decision.
  RenderJob job = scene();
  job.options.glossy = false;
  job.options.soft_shadows = false;
  job.options.samples = 1;
  ASSERT_FALSE(make_plan(job).random);
  const std::vector<float> one = picture(job);
  for (const std::uint64_t seed : {1ull, 2ull, 0xffffffffffffffffull}) {
    job.options.seed = seed;
    EXPECT_EQ(picture(job), one) << seed;
  }
  // And each feature brings it back.
  job.options.glossy = true;
  EXPECT_TRUE(make_plan(job).random);
  EXPECT_NE(picture(job), one);
  job.options.glossy = false;
  job.options.soft_shadows = true;
  EXPECT_TRUE(make_plan(job).random);
  EXPECT_NE(picture(job), one);
}

TEST(Chance, DrawsTheSameForTheSameSeed) {
  RenderJob job = scene();
  job.options.seed = 7;
  EXPECT_EQ(picture(job), picture(job));
  RenderJob other = job;
  other.options.seed = 8;
  EXPECT_NE(picture(job), picture(other));
}

TEST(BadSamples, AreCountedLocatedAndDoNotSpread) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    // A ball that covers the middle pixel alone, in a mirror as well.
    RenderJob job = test::job_looking({0, 0, 0}, {0, 0, -1}, 5, 5);
    job.options.background = {Rgb(0.5), Rgb(0.5)};
    const RenderResult clean = test::rendered(job);
    add(job, Sphere{{0, 0, -10}, 0.1}, {}, test::glowing(Rgb(bad)));
    const RenderResult result = test::rendered(job);
    EXPECT_EQ(result.statistics.bad_samples, 1u);
    EXPECT_EQ(result.statistics.first_bad_x, 2);
    EXPECT_EQ(result.statistics.first_bad_y, 2);
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 5; ++x) {
        const bool hit = x == 2 && y == 2;
        EXPECT_EQ(test::pixel(result.film, x, y), hit ? Rgb(0.0) : test::pixel(clean.film, x, y));
      }
    }
  }
}

TEST(DimLights, AddUpHoweverManyTheyAre) {
  // Each of 20 000 is below anything that shows; together they are as bright as one.
  constexpr int count = 20000;
  RenderJob job = test::bare_job();
  job.options.max_error = RenderOptions{}.max_error;
  add(job, Plane{}, Affine::translation({0, -1, 0}), matt(Rgb(1.0)));
  for (int i = 0; i < count; ++i) {
    job.lights.push_back({.position = {0, 3, -1}, .colour = Rgb(1.0 / count)});
  }
  EXPECT_NEAR(test::Probe(job)({0, 0, 0}, {0, -1, -1}).r, 1.0, job.options.max_error);
}

}  // namespace
}  // namespace rt
