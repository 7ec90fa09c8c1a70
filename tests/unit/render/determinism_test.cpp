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

TEST(Determinism, AHierarchyFindsWhatTryingAllFinds) {
  for (const double offset : {0.0, 1e5, 1e7}) {
    RenderJob job = test::mixed_scene(160, 120);
    for (Instance& instance : job.instances) {
      instance.world_from_model.offset += Vec3(offset, -offset, offset);
      instance.model_from_world = *inverse(instance.world_from_model);
    }
    for (Light& light : job.lights) {
      light.position += Vec3(offset, -offset, offset);
    }
    job.camera.eye += Vec3(offset, -offset, offset);
    job.options.accel = AccelChoice::none;
    const Film one_by_one = test::rendered(job).film;
    job.options.accel = AccelChoice::bvh;
    EXPECT_EQ(one_by_one.pixels, test::rendered(job).film.pixels) << offset;
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
