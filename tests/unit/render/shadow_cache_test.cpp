// Cells of space, as the shadow cache numbers them.
#include <gtest/gtest.h>

#include <random>

#include "rt/render/accel/shadow_cache.h"
#include "scenes.h"

namespace rt {
namespace {

TEST(ShadowCache, CellsOfSeveralPointsAreThoseOfEach) {
  const RenderPlan plan = make_plan(test::mixed_scene(64, 48));
  const ShadowCache cache(plan);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-1074.0, 1024.0);
  std::uniform_real_distribution<double> small(-3.0, 3.0);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  int nowhere = 0;
  for (int n = 0; n < 2000; ++n) {
    Wide3 points;
    for (int i = 0; i < lanes; ++i) {
      const double scale = std::exp2(n % 2 == 0 ? small(random) : exponent(random));
      points.set(i, n == 0 ? Vec3(0.0)
                           : scale * Vec3(value(random), value(random), n % 3 == 0 ? 0.0 : value(random)));
    }
    const Wide cells = cache.cells_of(points);
    for (int i = 0; i < lanes; ++i) {
      const ShadowCache::Cell one = cache.cell_of(points.lane(i));
      ASSERT_EQ(cells[static_cast<std::size_t>(i)], static_cast<double>(one)) << n;
      nowhere += one == ShadowCache::nowhere ? 1 : 0;
    }
  }
  EXPECT_GT(nowhere, lanes);
}

// The first to ask in a cell learns nothing, the next what is known of the whole cell; one that asks
// at once learns that at once.
TEST(ShadowCache, AnswersTheSecondWhoAsks) {
  RenderJob job = test::job_looking({0, 0, 9}, {0, 0, 0}, 64, 48);
  job.options.accel = AccelChoice::list;
  test::add(job, Sphere{}, {}, test::matt(Rgb(0.5)));
  job.lights.push_back({});
  job.lights[0].position = {0, 9, 0};
  const RenderPlan plan = make_plan(job);
  ShadowCache cache(plan);
  const Vec3 eye = job.camera.eye;
  const ShadowCache::Cell below = cache.cell_of(Vec3(0.0, -3.0, 0.0) - eye);
  const ShadowCache::Cell beside = cache.cell_of(Vec3(5.0, 0.0, 0.0) - eye);
  ASSERT_NE(below, beside);
  EXPECT_FALSE(cache.towards(0, below).known);
  const Candidates again = cache.towards(0, below);
  EXPECT_TRUE(again.known);
  EXPECT_EQ(again.instances.size(), 1u);
  const Candidates at_once = cache.towards(0, beside, true);
  EXPECT_TRUE(at_once.known);
  EXPECT_TRUE(at_once.instances.empty());
  EXPECT_FALSE(cache.towards(0, ShadowCache::nowhere, true).known);
}

}  // namespace
}  // namespace rt
