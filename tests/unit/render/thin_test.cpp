// Things narrower than a pixel keep their energy at the default settings.
#include <gtest/gtest.h>

#include <algorithm>
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
  const ThinBox box{{0, 0, -10}, {Vec3(5, 0, 0), Vec3(0, 0.01, 0), Vec3(0, 0, 0.01)}};
  const auto coverage = [&](const Vec3& from, double t_max) {
    return box.coverage({{from, {0, 0, -1}}, 0.0, 0.01}, t_max);
  };
  // A stripe of width 0.02 across a disc of radius 0.1.
  const double stripe = 0.02 * 0.2 / (pi * 0.01);
  EXPECT_NEAR(coverage({0, 0, 0}, 100), stripe, 1e-3 * stripe);
  EXPECT_NEAR(coverage({4, 0.1, 0}, 100), stripe, 1e-3 * stripe);
  EXPECT_EQ(coverage({4, 0.2, 0}, 100), 0.0);
  EXPECT_EQ(coverage({5.3, 0, 0}, 100), 0.0);
  EXPECT_EQ(coverage({0, 0, 0}, 9), 0.0);
}

TEST(Thin, ABeamsCubesMeetBoxes) {
  const Bounds box{{1, -1, 10}, {3, 1, 12}};
  const Beam widening{{{0, 0, 0}, {0, 0, 1}}, 0.0, 0.1};
  EXPECT_TRUE(widening.meets(box, 100));   // as wide as 1 at t = 10
  EXPECT_FALSE(widening.meets(box, 9.9));  // where it ends before
  EXPECT_FALSE((Beam{{{0, 0, 0}, {0, 0, 1}}, 0.0, 0.07}.meets(box, 100)));
  EXPECT_FALSE((Beam{{{0, 0, 0}, {0, 0, 1}}, 0.99, 0.0}.meets(box, 100)));
  EXPECT_TRUE((Beam{{{0, 0, 0}, {0, 0, 1}}, 1.0, 0.0}.meets(box, 100)));
  // One that has ended, but for its axis, before it is there; one along an axis beside the box.
  EXPECT_FALSE((Beam{{{0, 0, 0}, {0, 0, 1}}, 2.0, -0.2}.meets(box, 100)));
  EXPECT_TRUE((Beam{{{2, 0, 0}, {0, 0, 1}}, 0.0, 0.0}.meets(box, 100)));
}

/// Wires, beads and rings of all widths about the origin, some behind others, and a floor.
RenderJob tangle() {
  RenderJob job;
  job.options.width = 28;
  job.options.height = 21;
  job.options.samples = 0;
  for (int i = 0; i < 120; ++i) {
    const double a = 1.7 * i;
    const Vec3 at{0.5 * std::sin(a), 0.5 * std::cos(2.3 * a), 0.5 * std::sin(0.7 * a + 1.0)};
    const Affine there = Affine::translation(at) * Affine::rotation(i % 3, 40.0 * i);
    const double thick = 0.05 * std::pow(0.9, i % 60);
    if (i % 3 == 0) {
      test::add(job, Cylinder{}, there * Affine::scaling({thick, 0.4, thick}), shining());
    } else if (i % 3 == 1) {
      test::add(job, Sphere{}, there * Affine::scaling(Vec3(thick)), shining());
    } else {
      test::add(job, Torus{0.2, 0.3 * thick}, there, shining());
    }
  }
  test::add(job, Plane{}, Affine::translation({0, -0.8, 0}), test::matt(Rgb(0.8)));
  job.lights.push_back({.position = {3, 4, 2}, .colour = Rgb(1.0)});
  return job;
}

std::vector<int> pilots_of(const RenderJob& job) {
  const RenderPlan plan = make_plan(job);
  EXPECT_NE(plan.thin, nullptr);
  std::vector<int> pilots;
  for (int y = 0; y < job.options.height; ++y) {
    for (int x = 0; x < job.options.width; ++x) {
      pilots.push_back(thin_pilots(plan, x, y));
    }
  }
  return pilots;
}

// From close by, from so far that rays are clipped, and where all is narrower than a pixel.
TEST(Thin, EverySearchFindsTheSame) {
  struct View {
    Vec3 eye;
    double fov;
  };
  for (const View& view : {View{{0.3, 0.2, 1.6}, 50.0}, View{{0, 4000, 9000}, 0.012},
                           View{{0, 30, 90}, 90.0}, View{{0.1, 0.05, 0.02}, 100.0}}) {
    RenderJob job = tangle();
    job.camera = {view.eye, -view.eye, {0, 1, 0}, view.fov};
    const std::vector<int> expected = pilots_of(job);
    EXPECT_GT(std::ranges::count_if(expected, [](int n) { return n > 0; }), 0) << view.eye.z;
    RenderJob larger = job;  // by one that is not seen: then all boxes together are elsewhere
    test::add(larger, Sphere{20.0 * view.eye + Vec3(30, 0, 0), 0.001}, {}, shining());
    for (const AccelChoice accel :
         {AccelChoice::none, AccelChoice::list, AccelChoice::grid, AccelChoice::bvh}) {
      job.options.accel = accel;
      EXPECT_EQ(pilots_of(job), expected) << static_cast<int>(accel) << ' ' << view.eye.z;
      larger.options.accel = accel;
      EXPECT_EQ(pilots_of(larger), expected) << static_cast<int>(accel) << ' ' << view.eye.z;
    }
  }
}

// Where they cover the pixel there is little between them to miss: it needs no more pilots.
TEST(Thin, ManyTogetherAskForNoMore) {
  const auto pilots_about = [](int beads) {
    RenderJob job = looking_down();
    const double middle = 0.5 / size;
    for (int i = 0; i < beads; ++i) {
      const double a = 2.0 * pi * i / 16.0;
      test::add(job, Sphere{{middle + std::sin(a) / size, 0, middle + std::cos(a) / size}, 0.3 / size},
                {}, shining());
    }
    return thin_pilots(make_plan(job), size / 2, size / 2);
  };
  EXPECT_GT(pilots_about(1), 0);
  EXPECT_GT(pilots_about(6), 0);   // their boxes are 0.44 of the beam's disc: less than 0.51
  EXPECT_EQ(pilots_about(16), 0);  // 1.17
}

}  // namespace
}  // namespace rt
