// The same bytes whatever the threads, the crop and the way candidates are found.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace rt {
namespace {

TEST(Determinism, BytesDoNotDependOnThreads) {
  RenderJob job = test::mixed_scene(97, 61);
  job.options.samples = 4;
  const RenderResult one = test::rendered(job, 1);
  for (int threads : {2, 7}) {
    const RenderResult many = test::rendered(job, threads);
    EXPECT_EQ(one.film.pixels, many.film.pixels) << threads;
    EXPECT_EQ(one.statistics.rays.total(), many.statistics.rays.total());
  }
}

TEST(Determinism, ACropEqualsThatPartOfTheFullPicture) {
  RenderJob job = test::mixed_scene(97, 61);
  job.options.samples = 4;
  const Film full = test::rendered(job).film;
  const Crop crop{33, 7, 40, 29};
  const Film part = render(make_plan(job), crop, {}).film;
  for (int y = 0; y < crop.height; ++y) {
    for (int x = 0; x < crop.width; ++x) {
      EXPECT_EQ(test::pixel(part, x, y), test::pixel(full, x + crop.x, y + crop.y));
    }
  }
}

/// Pictures by every way of finding candidates equal the one made by trying all.
void expect_equal_searches(RenderJob job, const std::string& what) {
  job.options.accel = AccelChoice::none;
  const Film one_by_one = test::rendered(job).film;
  for (const AccelChoice accel :
       {AccelChoice::automatic, AccelChoice::list, AccelChoice::grid, AccelChoice::bvh}) {
    job.options.accel = accel;
    EXPECT_EQ(one_by_one.pixels, test::rendered(job).film.pixels)
        << what << ", search " << static_cast<int>(accel);
  }
}

// The caches of what a pixel's block shows and of what may shadow a cell are at work here: lights
// among the shapes, far beyond them, extended, moving; more shapes than an entry holds; glass that
// dims; wide and narrow views; a camera far away.
TEST(Determinism, EveryWayToFindCandidatesFindsTheSame) {
  RenderJob job = test::mixed_scene(80, 60);
  Material dim = test::matt({0.2, 0.3, 0.4});
  dim.opacity = 0.4;
  for (int i = 0; i < 40; ++i) {
    test::add(job, Sphere{},
              Affine::translation({0.35 * (i % 8) - 1.2, 0.2, 0.3 * (i / 8) - 1}) *
                  Affine::scaling(Vec3(0.17)),
              i % 5 == 0 ? dim : test::matt({0.5, 0.5, 0.1}));
  }
  expect_equal_searches(job, "crowd");
  job.lights[0].position = {2e7, 3e7, 1e7};
  expect_equal_searches(job, "a light far away");
  job.lights[0].position = {0.1, 0.45, 0.2};
  expect_equal_searches(job, "a light within");
  job.lights[0].position = {1, 4, 2};
  job.lights[0].radius = 0.8;
  job.lights[1].rectangle = Light::Rectangle{{2, 0, 0}, {0, 0.5, 1}};
  job.options.samples = 4;
  expect_equal_searches(job, "extended lights");
  job.lights[1].travel = {1, -1, 2};
  expect_equal_searches(job, "a light that moves");
  job.options.samples = 1;
  job.camera.fov = 120;
  expect_equal_searches(job, "a wide view");
  job.camera.fov = 0.02;
  job.camera.eye *= 1e3;
  job.camera.view *= 1e3;
  expect_equal_searches(job, "a view from afar");
}

TEST(Determinism, SearchesFindTheSameFarFromTheOrigin) {
  for (const double offset : {0.0, 1e5, 1e7}) {
    RenderJob job = test::mixed_scene(160, 120);
    for (std::size_t i = 0; i < job.instances.size(); ++i) {
      Instance moved = job.instances[i];
      moved.world_from_model.offset += Vec3(offset, -offset, offset);
      job.instances.replace(i, moved);
    }
    for (Light& light : job.lights) {
      light.position += Vec3(offset, -offset, offset);
    }
    job.camera.eye += Vec3(offset, -offset, offset);
    expect_equal_searches(job, std::to_string(offset));
  }
}

TEST(Determinism, SamplesThatAreNotFiniteAreCountedAndLeftOut) {
  RenderJob job = test::job_looking({0, 0, 5}, {0, 0, 0}, 9, 9);
  Material bad;
  bad.emission = Rgb(NAN);
  test::add(job, Sphere{}, {}, bad);
  const RenderResult result = test::rendered(job);
  EXPECT_GT(result.statistics.bad_samples, 0u);
  for (const float p : result.film.pixels) {
    EXPECT_TRUE(std::isfinite(p));
  }
}

}  // namespace
}  // namespace rt
