// What moves while the shutter is open.
#include <gtest/gtest.h>

#include <cmath>

#include "rt/math/warp.h"
#include "scenes.h"

namespace rt {
namespace {

using test::add_moving;
using test::give_path;
using test::moving;

Material shining() {
  Material m;
  m.kd = Rgb(0.0);
  m.emission = Rgb(1.0);
  return m;
}

/// A camera that sees the square from -0.5 to 0.5 of the plane z = 0, nearly in parallel.
RenderJob head_on(int size) {
  RenderJob job = test::job_looking({0, 0, 1000}, {0, 0, 0}, size, size);
  job.camera.fov = 2.0 * std::atan(0.5 / 1000.0) * 180.0 / pi;
  job.options.filter = Filter::box;
  job.options.samples = 1024;
  return job;
}

// An edge that crosses the picture evenly: a pixel is bright for the share of time it is behind it.
TEST(Motion, AMovingEdgeCoversInProportionToTime) {
  RenderJob job = head_on(16);
  Pose to;
  to.translate = {0.5, 0, 0};
  add_moving(job, Box{{-1.25, -1, -1e-3}, {-0.25, 1, 0}}, {}, shining(), moving(to));
  const Film film = test::rendered(job).film;
  for (int x = 0; x < 16; ++x) {
    const double behind = std::clamp((0.25 - ((x + 0.5) / 16 - 0.5)) / 0.5, 0.0, 1.0);
    if (x != 3 && x != 4 && x != 11 && x != 12) {  // where the share has a kink
      EXPECT_NEAR(test::pixel(film, x, 8).r, behind, 0.004) << x;
    }
  }
}

// A half-plane that turns about the picture's centre: bright between its first and its last angle
// for the share of time that is left. A chord between the two would cut the corner.
TEST(Motion, ASpokeTurnsOnItsArc) {
  RenderJob job = head_on(32);
  Pose to;
  to.axis = {0, 0, 1};
  to.degrees = 350.0;
  const double r = 0.45;
  const double half_width = 0.01;
  add_moving(job, Box{{0, -half_width, -1e-3}, {r, half_width, 0}}, {}, shining(), moving(to));
  const Film film = test::rendered(job).film;
  double total = 0.0;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const Vec2 p{(x + 0.5) / 32 - 0.5, 0.5 - (y + 0.5) / 32};
      const double radius = glm::length(p);
      const double angle = std::atan2(p.y, p.x) * 180.0 / pi;
      total += test::pixel(film, x, y).r;
      if (radius > 0.15 && radius < 0.4 && (angle < -30.0 || angle > 20.0)) {
        // The spoke takes 2 asin(h / radius) of the 350 degrees.
        const double share = 2.0 * std::asin(half_width / radius) * 180.0 / pi / 350.0;
        EXPECT_NEAR(test::pixel(film, x, y).r, share, 0.25 * share + 0.003) << x << ' ' << y;
      }
      if (radius > 0.49) {
        EXPECT_EQ(test::pixel(film, x, y).r, 0.0) << x << ' ' << y;
      }
    }
  }
  EXPECT_NEAR(total / (32 * 32), 2.0 * half_width * r, 0.01 * 2.0 * half_width * r);
}

/// Everything moves: a node below a moving node, a light, the camera.
RenderJob all_moving() {
  RenderJob job = test::mixed_scene(40, 30);
  Pose outer;
  outer.translate = {1, 0, 0};
  outer.degrees = 70;
  Pose inner;
  inner.scale = Vec3(1.5);
  inner.translate = {0, 0.5, 0};
  const Material m = test::matt({0.8, 0.3, 0.2});
  add_moving(job, Box{}, Affine::translation({-1, 0, 2.5}), m, moving(outer));
  give_path(job,
            extended(job.instances.back().motion, {Affine::scaling(Vec3(0.5)), moving(inner)}));
  job.lights[0].travel = {-3, 1, 0};
  auto to = std::make_shared<Camera>(job.camera);
  to->eye += Vec3(0.3, 0.1, 0);
  to->view = Vec3(0.05, -0.3, -1);
  job.camera.to = to;
  return job;
}

TEST(Motion, IsTheMeanOfFrozenTimes) {
  RenderJob job = all_moving();
  job.options.samples = 1024;
  const Film blurred = test::rendered(job).film;
  constexpr int times = 1024;
  std::vector<double> mean(blurred.pixels.size());
  std::vector<double> square(blurred.pixels.size());
  job.options.samples = 4;
  for (int i = 0; i < times; ++i) {
    job.options.seed = static_cast<std::uint64_t>(i);
    job.options.shutter_open = job.options.shutter_close = (i + 0.5) / times;
    const Film frozen = test::rendered(job, 2).film;
    for (std::size_t k = 0; k < mean.size(); ++k) {
      const double v = double{frozen.pixels[k]};
      mean[k] += v / times;
      square[k] += v * v / times;
    }
  }
  double z_square = 0.0;
  int beyond = 0;
  for (std::size_t k = 0; k < mean.size(); ++k) {
    // Of the mean of frozen pictures, and as much of the blurred one.
    const double error = std::sqrt(2.0 * std::max(square[k] - mean[k] * mean[k], 1e-8) / times);
    const double z = (double{blurred.pixels[k]} - mean[k]) / error;
    z_square += z * z / static_cast<double>(mean.size());
    beyond += std::abs(z) > 3.0 ? 1 : 0;
  }
  EXPECT_LT(z_square, 1.0);
  EXPECT_LT(beyond, static_cast<int>(mean.size()) / 100);
}

TEST(Motion, BytesDependOnNeitherThreadsNorCropNorHierarchy) {
  RenderJob job = all_moving();
  job.options.samples = 0;
  job.options.max_samples = 64;
  const Film full = test::rendered(job, 1).film;
  EXPECT_EQ(full.pixels, test::rendered(job, 7).film.pixels);
  const Film part = render(make_plan(job), {9, 4, 20, 20}, {}).film;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      ASSERT_EQ(test::pixel(part, x, y), test::pixel(full, x + 9, y + 4));
    }
  }
  job.options.accel = AccelChoice::none;  // boxes hold at all times
  EXPECT_EQ(full.pixels, test::rendered(job).film.pixels);
  job.options.accel = AccelChoice::bvh;
  EXPECT_EQ(full.pixels, test::rendered(job).film.pixels);
}

TEST(Motion, WhatStandsStillPaysNothing) {
  RenderJob job = test::mixed_scene(40, 30);
  job.options.samples = 4;
  const RenderPlan still = make_plan(job);
  EXPECT_FALSE(still.moves);
  for (const PlannedInstance& instance : still.instances) {
    EXPECT_FALSE(instance.moves());
  }
  // A shutter that does not open, and --disable motion-blur, freeze all.
  job = all_moving();
  job.options.shutter_open = job.options.shutter_close = 0.0;
  EXPECT_FALSE(make_plan(job).moves);
  const Film frozen = test::rendered(job).film;
  job.options.shutter_close = 1.0;
  job.options.motion_blur = false;
  EXPECT_EQ(test::rendered(job).film.pixels, frozen.pixels);
}

TEST(Motion, KeysAreAsDenseAsATenthOfAPixelAsks) {
  RenderJob job = head_on(1000);
  Pose to;
  to.axis = {0, 0, 1};
  to.degrees = 350.0;
  add_moving(job, Box{{0, -0.01, 0}, {0.45, 0.01, 0.01}}, {}, shining(), moving(to));
  const RenderPlan plan = make_plan(job);
  ASSERT_TRUE(plan.instances[0].moves());
  const PlannedMotion& motion = plan.placements.motion(plan.instances[0].placement);
  EXPECT_LT(motion.keys.size(), 500u);
  double worst = 0.0;
  for (int i = 0; i <= 10000; ++i) {
    const double t = i / 10000.0;
    const double angle = 350.0 * t * pi / 180.0;
    const Vec3 tip = motion.at(t).render_from_model.point({0.45, 0, 0});
    worst = std::max(worst, glm::length(Vec2(tip) - 0.45 * Vec2(std::cos(angle), std::sin(angle))));
  }
  EXPECT_LT(worst, 0.1 / 1000);
  const Bounds box = motion.bounds({{0, -0.01, 0}, {0.45, 0.01, 0.01}});
  EXPECT_GE(box.hi.x, 0.45);
  EXPECT_LT(box.hi.x, 0.46);
}

// Where keys and the middles between them all show the thing as it was.
TEST(Motion, SixTurnsAreNotTakenForStandingStill) {
  RenderJob job = head_on(100);
  Pose to;
  to.axis = {0, 0, 1};
  to.degrees = 6 * 360.0;
  add_moving(job, Box{{0, -0.01, 0}, {0.45, 0.01, 0.01}}, {}, shining(), moving(to));
  const RenderPlan plan = make_plan(job);
  const PlannedMotion& motion = plan.placements.motion(plan.instances[0].placement);
  const Vec3 tip = motion.at(1.0 / 24).render_from_model.point({0.45, 0, 0});
  EXPECT_NEAR(tip.x, 0.0, 0.1 / 100);
  EXPECT_NEAR(tip.y, 0.45, 0.1 / 100);
}

TEST(Motion, TurnsAboutOppositeAxesGoThroughRest) {
  Pose from;
  from.axis = {0, 1, 0};
  from.degrees = 90;
  Pose to = from;
  to.axis = {0, -1, 0};
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    Pose expected = from;
    expected.degrees = 90.0 - 180.0 * share;
    const Vec3 there = between(from, to, share).affine().point({1, 2, 3});
    const Vec3 right = expected.affine().point({1, 2, 3});
    EXPECT_LT(glm::length(there - right), 1e-14)
        << share << ' ' << there.x << ' ' << there.y << ' ' << there.z << ' ' << right.x << ' ' << right.y << ' ' << right.z;
  }
}

}  // namespace
}  // namespace rt
