/// Lines across a light, in place of points on it: the same mean, far less scatter.
#include <gtest/gtest.h>

#include <cstdio>

#include "rt/render/accel/shadow_cache.h"
#include "unit/render/probe.h"

namespace rt {
namespace {

using test::add;
using test::matt;
using test::Probe;

/// A floor with things of every shape on it and above, under that light.
RenderJob crowded(const Light& light, double shine = 0.3, bool with_ring = true) {
  RenderJob job = test::bare_job();
  Material polished = matt({0.7, 0.6, 0.5});
  polished.ks = Rgb(shine);
  polished.shininess = 8;
  add(job, Plane{}, {}, polished);
  const Material dark = matt(Rgb(0.0));
  add(job, Sphere{{-1.5, 1, 0}, 0.6}, {}, dark);
  add(job, Box{}, Affine::translation({1, 0, 0.5}) * Affine::rotation(1, 25), dark);
  add(job, Cylinder{}, Affine::translation({-0.2, 0, 1.5}) * Affine::scaling({0.3, 1.3, 0.4}),
      dark);
  add(job, PointedCone{}, Affine::translation({2.4, 0, 2}) * Affine::scaling({0.5, 1.5, 0.5}),
      dark);
  add(job, Blob{}, Affine::translation({0.3, 1.2, -1.4}) * Affine::rotation(2, 40), dark);
  add(job, Square{1.0}, Affine::translation({-2, 1.5, 1.8}) * Affine::rotation(0, 20), dark);
  if (with_ring) {
    add(job, Torus{0.5, 0.15}, Affine::translation({-1, 0.7, 2.6}), dark);
  }
  job.lights.push_back(light);
  return job;
}

/// The same with so many specks in a corner of the box about the light, where none hides any of it,
/// that nobody knows which few things may: points are drawn and asked for.
RenderJob by_points(RenderJob job) {
  const Light& light = job.lights[0];
  const Vec3 corner =
      light.rectangle ? 0.5 * (light.rectangle->u + light.rectangle->v) : Vec3(light.radius);
  for (std::size_t i = 0; i <= ShadowCache::most; ++i) {
    add(job, Sphere{light.position + 0.999 * corner, 1e-12}, {}, matt(Rgb(0.0)));
  }
  return job;
}

const Light lights[] = {
    {.position = {1, 5, 2}, .rectangle = {{{2, 0, 0}, {0, 0, 1.5}}}},
    {.position = {-4, 2, 3}, .falloff = {0, 0.1, 0.02}, .rectangle = {{{0, 2, 0}, {1, 0, 1.2}}}},
    {.position = {1, 5, 2}, .radius = 1.0},
    {.position = {4, 1, 2}, .falloff = {0, 0, 0.05}, .radius = 1.5},  // partly below the floor
};

// Forty points in four lights, three colours: beyond 4.5 standard errors once in 300 runs.
TEST(LightLines, HaveTheMeanOfPoints) {
  int in_penumbra = 0;
  for (const Light& light : lights) {
    Probe lines(crowded(light));
    Probe points(by_points(crowded(light)));
    for (int i = 0; i < 40; ++i) {
      const Vec3 eye{0.8 * (i % 8) - 3.1, 0.01, 0.9 * (i / 8) - 1.1};
      const Vec3 way{0.3, -1, 0.2};
      const test::Estimate a = lines.estimate(eye, way, 16, 64);
      const test::Estimate b = points.estimate(eye, way, 16, 256);
      for (int k = 0; k < 3; ++k) {
        const double error = std::hypot(a.standard_error[k], b.standard_error[k]);
        EXPECT_NEAR(a.mean[k], b.mean[k], 4.5 * error + 1e-6) << i << ' ' << k;
      }
      in_penumbra += b.standard_error.r > 1e-3 ? 1 : 0;
    }
  }
  EXPECT_GT(in_penumbra, 15);
}

// In the half-shadow of convex things on a matt floor.
TEST(LightLines, ScatterAFractionOfWhatPointsDo) {
  for (const std::size_t which : {0u, 2u}) {
    const RenderJob job = crowded(lights[which], 0.0, false);
    Probe lines(job);
    Probe points(by_points(job));
    double of_lines = 0.0;
    double of_points = 0.0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 eye{0.3 * (i % 20) - 3.0, 0.01, 0.4 * (i / 20) - 1.5};
      of_lines += std::pow(lines.estimate(eye, {0, -1, 0}, 8, 16).standard_error.r, 2);
      of_points += std::pow(points.estimate(eye, {0, -1, 0}, 8, 16).standard_error.r, 2);
    }
    std::printf("light %zu: error of lines %.3f of that of points at 16 samples\n", which,
                std::sqrt(of_lines / of_points));
    EXPECT_LT(of_lines, 0.1 * of_points);
  }
}

TEST(LightLines, AreExactWhereNothingOrOneThingHidesAll) {
  for (const std::size_t which : {0u, 2u}) {
    RenderJob job = test::bare_job();
    add(job, Plane{}, {}, matt(Rgb(1.0)));
    add(job, Box{{-3, 0.5, -3}, {3, 0.6, 3}}, {}, matt(Rgb(0.0)));
    job.lights.push_back(lights[which]);
    Probe probe(job);
    const test::Estimate open = probe.estimate({20, 1, 0}, {0, -1, 0}, 8, 1);
    EXPECT_GT(open.mean.r, 0.1);
    EXPECT_LT(open.standard_error.r, 1e-8);  // rounding of the sums it is made of
    EXPECT_EQ(probe.estimate({0, 0.01, 0}, {0, -1, 0}, 8, 1).mean.r, 0.0);
  }
}

// Ceilings flush with the light, and things that reach up to it, wherever the eye is.
TEST(LightLines, AreNotHiddenByWhatLiesInTheLightsPlane) {
  for (const double height : {2.0, 1.0 / 3.0, 1e3 + 0.1}) {
    for (const Vec3& eye : {Vec3(0.1, 1, 0.2), Vec3(0.3, 1e4, 0.7)}) {
      RenderJob open = test::bare_job();
      open.camera.eye = eye;
      open.options.width = open.options.height = 4096;  // small cells, of which blockers are known
      add(open, Plane{}, {}, matt(Rgb(1.0)));
      open.lights.push_back(
          {.position = {0.1, height, 0.2}, .rectangle = {{{3, 0, 0}, {0, 0, 3}}}});
      RenderJob ceiling = open;
      add(ceiling, Square{40.0}, Affine::translation({0, height, 0}), matt(Rgb(1.0)));
      add(ceiling, Box{{-9, 0, -9}, {9, 1, 9}}, Affine::translation({0, height, 0}),
          matt(Rgb(1.0)));
      Probe lit(open);
      Probe covered(ceiling);
      for (std::uint32_t i = 0; i < 64; ++i) {
        const Vec3 from = Vec3(0.2 * i - 5.0, 0.2, 0.3) - eye;
        const Sampler s = Sampler(3, 0, 0, 0).at(i);
        const double truth = lit(from, {0.1, -1, 0.1}, s).r;
        EXPECT_NEAR(covered(from, {0.1, -1, 0.1}, s).r, truth, 1e-9 * truth) << height;
      }
    }
  }
}

}  // namespace
}  // namespace rt
