/// A white furnace: surroundings of radiance 1 on all sides. What neither absorbs nor shines is
/// then invisible: it returns 1 in every direction, and no lobe returns more than it receives.
#include <gtest/gtest.h>

#include "unit/render/probe.h"

namespace rt {
namespace {

using test::add;
using test::glass;

RenderJob furnace(const Material& material, const Shape& shape) {
  RenderJob job = test::bare_job();
  job.options.max_depth = 4000;
  job.options.background = {Rgb(1.0), Rgb(1.0)};
  add(job, shape, Affine::translation({0, 0, -3}), material);
  return job;
}

Material frosted(double ior, double glossiness) {
  Material m = glass(ior);
  m.glossiness = glossiness;
  return m;
}

Material mirror(double reflectivity, double glossiness) {
  Material m = test::matt(Rgb(0.0));
  m.reflectivity = Rgb(reflectivity);
  m.glossiness = glossiness;
  return m;
}

// From the middle of the ball to its rim.
const double heights[] = {0.0, 0.5, 0.9, 0.99, 0.9999};

/// From the eye past the ball's centre, 3 away, at that distance.
Vec3 towards(double height) { return {height / std::sqrt(9.0 - height * height), 0, -1}; }

TEST(WhiteFurnace, GlassAndMirrorsGiveBackAll) {
  for (const Material& m : {glass(1.5), glass(2.4), glass(0.7), mirror(1.0, 0.0)}) {
    test::Probe probe(furnace(m, Sphere{}));
    ASSERT_FALSE(probe.plan().random);
    for (const double h : heights) {
      // Left out are branches below 1e-12 / 16 and those of more than 4000 bounces, of which each
      // loses at least 5% to the outside (F < 0.95 at the height 0.9999).
      EXPECT_NEAR(probe({0, 0, 0}, towards(h)).r, 1.0, 1e-10) << m.ior << " " << h;
    }
  }
  test::Probe half(furnace(mirror(0.5, 0.0), Sphere{}));
  EXPECT_NEAR(half({0, 0, 0}, {0, 0, -1}).r, 0.5, 1e-15);
}

TEST(WhiteFurnace, GlossyMirrorsGiveBackAll) {
  for (const double g : {0.05, 0.3, 0.7, 1.0}) {
    test::Probe probe(furnace(mirror(1.0, g), Sphere{}));
    for (const double h : heights) {
      // Weights vary, between 0 and 2, only where the horizon cuts the lobe: 4096 well spread
      // samples then err by at most 4e-4 (measured at g = 0.05, h = 0.9999; 1e-4 elsewhere).
      const test::Estimate got = probe.estimate({0, 0, 0}, towards(h), 16, 256);
      EXPECT_NEAR(got.mean.r, 1.0, 4.0 * got.standard_error.r + 1e-3) << g << " " << h;
      EXPECT_LT(got.standard_error.r, 5e-4);
    }
  }
}

// One surface of frosted glass: what it reflects and what it lets through, from either side.
TEST(WhiteFurnace, AFrostedSurfaceGivesBackAll) {
  for (const double g : {0.05, 0.3, 0.7, 1.0}) {
    for (const double side : {1.0, -1.0}) {
      RenderJob job = furnace(frosted(1.5, g), Plane{});
      job.options.max_depth = 1;
      test::Probe probe(job);
      for (const double tangent : {0.0, 0.5, 1.5, 10.0}) {
        const Vec3 origin{0, side, -3};
        const test::Estimate got = probe.estimate(origin, {tangent, -side, 0}, 16, 256);
        EXPECT_NEAR(got.mean.r, 1.0, 4.0 * got.standard_error.r + 1e-3) << g << " " << tangent;
        EXPECT_LT(got.standard_error.r, 5e-4);
      }
    }
  }
}

// Inside a frosted ball light is reflected totally many times over, and the weights of all its
// lobes multiply: a skewed distribution, of which 4096 samples seldom see the tail. Their mean errs
// by up to 5e-3, which their spread tells only within a factor.
TEST(WhiteFurnace, AFrostedBallGivesBackAll) {
  for (const double g : {0.05, 0.3, 0.7, 1.0}) {
    test::Probe probe(furnace(frosted(1.5, g), Sphere{}));
    for (const double h : heights) {
      const test::Estimate got = probe.estimate({0, 0, 0}, towards(h), 16, 256);
      EXPECT_NEAR(got.mean.r, 1.0, 4.0 * got.standard_error.r + 5e-3) << g << " " << h;
      EXPECT_LT(got.standard_error.r, 1e-2);
    }
  }
}

// Matt surfaces see lights and the ambient term, not the background. In ambient light of radiance 1
// a white one returns 1; and so it does inside a light: the mean of n.l over all directions is 1/4,
// so that a light that surrounds it needs the colour 4.
TEST(WhiteFurnace, MattGivesBackAmbientAndASurroundingLight) {
  for (const double kd : {0.25, 1.0}) {
    RenderJob ambient = furnace(test::matt(Rgb(kd)), Sphere{});
    ambient.ambient = Rgb(1.0);
    EXPECT_DOUBLE_EQ(test::Probe(ambient)({0, 0, 0}, {0, 0, -1}).r, kd);
    RenderJob light = furnace(test::matt(Rgb(kd)), Sphere{});
    light.lights.push_back({.position = {0, 1, 0}, .colour = Rgb(4.0), .radius = 10.0});
    test::Probe probe(light);
    for (const double h : heights) {
      // max(0, n.l) is continuous: 16384 samples of 4 max(0, n.l) err by some 3e-4.
      const test::Estimate got = probe.estimate({0, 0, 0}, towards(h), 16, 1024);
      EXPECT_NEAR(got.mean.r, kd, 1e-3) << h;
    }
  }
}

}  // namespace
}  // namespace rt
