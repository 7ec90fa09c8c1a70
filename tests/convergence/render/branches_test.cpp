/// At glass a path may follow one of two branches, chosen by chance: the mean must be that of
/// following both.
#include <gtest/gtest.h>

#include "unit/render/probe.h"

namespace rt {
namespace {

using test::add;
using test::bare_job;
using test::glass;

/// Three nested shells of dense glass with a glowing, coloured ball off the middle, before a
/// background: many paths of low weight, none alike.
RenderJob shells() {
  RenderJob job = bare_job();
  job.options.max_depth = 12;
  for (int i = 0; i < 3; ++i) {
    const double r = 3.0 - 0.8 * i;
    add(job, Sphere{{0, 0, -6}, r}, {}, glass(2.4));
    add(job, Sphere{{0.05, 0, -6}, r - 0.4}, {}, glass(1.0));
  }
  add(job, Sphere{{0.3, 0.2, -6.1}, 0.3}, {}, test::glowing({2, 1, 0.5}));
  job.options.background = {Rgb(0.25, 0.5, 1.0), Rgb(0.25, 0.5, 1.0)};
  return job;
}

/// The same, with decisions left to chance as in a scene with an area light. The light itself is
/// black.
RenderJob by_chance(RenderJob job, double max_error) {
  job.options.max_error = max_error;
  job.lights.push_back({.position = {0, 50, 0}, .colour = Rgb(0.0), .radius = 1.0});
  return job;
}

class Branches : public testing::TestWithParam<double> {};

// Choices alone (no branch is negligible), and choices with roulette.
TEST_P(Branches, ChosenByChanceHaveTheMeanOfBoth) {
  constexpr int pixels = 256;
  constexpr std::uint32_t samples = 16;
  test::Probe full(shells());
  test::Probe chance(by_chance(shells(), GetParam()));
  ASSERT_FALSE(full.plan().random);
  ASSERT_TRUE(chance.plan().random);
  for (const Vec3& way : {Vec3(0, 0, -1), Vec3(0.2, 0.1, -1), Vec3(-0.35, 0.2, -1)}) {
    const Rgb truth = full({0, 0, 0}, way);
    const test::Estimate got = chance.estimate({0, 0, 0}, way, pixels, samples);
    for (int k = 0; k < 3; ++k) {
      // Nine comparisons in each of two runs: beyond 4 standard errors once in 900 times.
      EXPECT_NEAR(got.mean[k], truth[k], 4.0 * got.standard_error[k]) << way.x << " channel " << k;
      EXPECT_LT(got.standard_error[k], 5e-3);  // else the test would see nothing
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MaxError, Branches, testing::Values(1e-12, 0.02, 0.5));

}  // namespace
}  // namespace rt
