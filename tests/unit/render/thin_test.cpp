// Things narrower than a pixel keep their energy at the default settings.
#include <gtest/gtest.h>

#include <cmath>

#include "rt/math/warp.h"
#include "rt/render/thin.h"
#include "scenes.h"

namespace rt {
namespace {

constexpr int size = 48;
constexpr double distance = 100.0;

/// A camera at the height `distance` that looks straight down on a square of edge 1.
RenderJob looking_down() {
  RenderJob job;
  job.camera = {
      {0, distance, 0}, {0, -1, 0}, {0, 0, -1}, 2.0 * std::atan(0.5 / distance) * 180.0 / pi};
  job.options.width = size;
  job.options.height = size;
  return job;
}

Material shining() {
  Material m;
  m.kd = Rgb(0.0);
  m.emission = Rgb(0.8);
  return m;
}

/// A cylinder of that diameter from the origin's sides, at an angle about y.
Affine lying(double diameter, double length, double degrees) {
  return Affine::rotation(1, degrees) * Affine::rotation(2, 90.0) *
         Affine::translation({0, -0.5 * length, 0}) *
         Affine::scaling({0.5 * diameter, length, 0.5 * diameter});
}

double sum(const Film& film) {
  double s = 0.0;
  for (std::size_t i = 0; i < film.pixels.size(); i += 3) {
    s += double{film.pixels[i]};
  }
  return s;
}

TEST(Thin, WiresInSightKeepTheirEnergy) {
  for (const double width : {0.02, 0.05, 0.1, 0.25, 0.5}) {
    double got = 0.0;
    double expected = 0.0;
    for (const double angle : {0.0, 13.0, 45.0, 71.0, 90.0}) {
      RenderJob job = looking_down();
      test::add(job, Cylinder{},
                Affine::translation({0.003, 0, 0.0041}) * lying(width / size, 0.8, angle),
                shining());
      const double here = sum(test::rendered(job).film);
      EXPECT_NEAR(here / (0.8 * 0.8 * size * width), 1.0, width < 0.1 ? 0.1 : 0.05)
          << width << ' ' << angle;
      got += here;
      expected += 0.8 * 0.8 * size * width;
    }
    EXPECT_NEAR(got / expected, 1.0, 0.05) << width;
  }
}

// The wire hangs one unit above the floor, beside what the camera sees; the light comes from far
// away, at 45 degrees.
TEST(Thin, WiresAsShadowsKeepTheirEnergy) {
  for (const double width : {0.02, 0.05, 0.1, 0.25, 0.5}) {
    double got = 0.0;
    double expected = 0.0;
    for (const double shift : {0.0, 0.0037, 0.0071}) {
      RenderJob job = looking_down();
      test::add(job, Plane{}, {}, test::matt(Rgb(0.8)));
      job.lights.push_back({.position = {1e4, 1e4, 0}, .colour = Rgb(1.0)});
      const double lit = sum(test::rendered(job).film);
      const double diameter = width / size * std::sqrt(0.5);  // its shadow is as wide as `width`
      test::add(job, Cylinder{},
                Affine::translation({1.0 + shift, 1.0, 0}) * lying(diameter, 0.8, 90),
                test::matt(Rgb(0.8)));
      got += lit - sum(test::rendered(job).film);
      expected += lit / (size * size) * 0.8 * size * width;
    }
    EXPECT_NEAR(got / expected, 1.0, 0.05) << width;
  }
}

TEST(Thin, BeadsKeepTheirEnergy) {
  for (const double width : {0.1, 0.25, 0.5}) {
    double got = 0.0;
    double expected = 0.0;
    for (const double shift : {0.0, 0.3, 0.7}) {
      RenderJob job = looking_down();
      for (int i = -7; i <= 7; ++i) {
        test::add(job,
                  Sphere{{(3 * i + shift) / size, 0, (2 * i - shift) / size}, 0.5 * width / size},
                  {}, shining());
      }
      got += sum(test::rendered(job).film);
      expected += 0.8 * 15 * 0.25 * pi * width * width;
    }
    EXPECT_NEAR(got / expected, 1.0, 0.05) << width;
  }
}

TEST(Thin, NothingIsThinInAnOrdinaryScene) {
  RenderJob job = test::mixed_scene(320, 240);
  job.options.samples = 0;
  EXPECT_EQ(make_plan(job).thin, nullptr);
}

TEST(Thin, RingsAreFoundAllAround) {
  RenderJob job = looking_down();
  test::add(job, Torus{0.35, 0.02 / size}, {}, shining());  // 0.04 pixels thick
  const double area = 2.0 * pi * 0.35 * size * 0.04;
  EXPECT_NEAR(sum(test::rendered(job).film) / (0.8 * area), 1.0, 0.05);
}

TEST(Thin, WhatTheBeamMissesDoesNotCount) {
  ThinBoxes boxes;
  boxes.add({0, 0, -10}, {Vec3(5, 0, 0), Vec3(0, 0.01, 0), Vec3(0, 0, 0.01)}, 1.0);
  boxes.build();
  const auto coverage = [&](const Vec3& from, double t_max) {
    return boxes.coverage({{from, {0, 0, -1}}, 0.0, 0.01}, t_max);
  };
  // A stripe of width 0.02 across a disc of radius 0.1.
  const double stripe = 0.02 * 0.2 / (pi * 0.01);
  EXPECT_NEAR(coverage({0, 0, 0}, 100), stripe, 1e-3 * stripe);
  EXPECT_NEAR(coverage({4, 0.1, 0}, 100), stripe, 1e-3 * stripe);
  EXPECT_EQ(coverage({4, 0.2, 0}, 100), 0.0);
  EXPECT_EQ(coverage({5.3, 0, 0}, 100), 0.0);
  EXPECT_EQ(coverage({0, 0, 0}, 9), 0.0);
}

}  // namespace
}  // namespace rt
