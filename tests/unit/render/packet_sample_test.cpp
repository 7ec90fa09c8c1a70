// Samples taken several at a time are those taken one by one, bit for bit, and cost the same rays.
#include <gtest/gtest.h>

#include <algorithm>

#include "packet_scenes.h"
#include "rt/render/sample.h"

namespace rt {
namespace {

constexpr AccelChoice searches[] = {AccelChoice::automatic, AccelChoice::none, AccelChoice::list,
                                    AccelChoice::grid, AccelChoice::bvh};

/// Every pixel: its centre where `centres`, else some samples.
std::vector<PixelSample> wanted(const RenderJob& job, bool centres) {
  std::vector<PixelSample> out;
  for (int y = 0; y < job.options.height; ++y) {
    for (int x = 0; x < job.options.width; ++x) {
      for (std::uint32_t i = 0; i < (centres ? 1u : 3u); ++i) {  // no multiple of the lanes
        out.push_back({x, y, i, centres});
      }
    }
  }
  return out;
}

struct Taken {
  std::vector<std::optional<Rgb>> values;
  RenderStatistics statistics;
  std::vector<std::uint8_t> quadrants;
};

Taken together(const RenderPlan& plan, const std::vector<PixelSample>& samples) {
  Taken out{std::vector<std::optional<Rgb>>(samples.size()), {}, {}};
  out.quadrants.resize(samples.size());
  PixelSampler sampler(plan);
  sampler.take_all(samples, out.values, out.statistics, out.quadrants);
  return out;
}

Taken one_by_one(const RenderPlan& plan, const std::vector<PixelSample>& samples) {
  Taken out;
  PixelSampler one(plan);
  for (const PixelSample& s : samples) {
    const Sampler sampler(plan.options.seed, s.x, s.y, s.index);
    out.values.push_back(s.at_centre ? one.take_at(s.x, s.y, Vec2(0.5), sampler, out.statistics)
                                     : one.take(s.x, s.y, sampler, out.statistics));
    const Vec2 u = sampler.pixel();
    out.quadrants.push_back(static_cast<std::uint8_t>((u.x < 0.5 ? 0 : 1) + (u.y < 0.5 ? 0 : 2)));
  }
  return out;
}

void expect_equal(const RenderPlan& plan, const std::vector<PixelSample>& samples,
                  const std::string& what) {
  const Taken many = together(plan, samples);
  const Taken one = one_by_one(plan, samples);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool elsewhere = !samples[i].at_centre && many.quadrants[i] != one.quadrants[i];
    if ((many.values[i] != one.values[i] || elsewhere) && wrong++ == 0) {
      ADD_FAILURE() << what << ": sample " << samples[i].index << " of pixel " << samples[i].x
                    << ", " << samples[i].y;
    }
  }
  EXPECT_EQ(wrong, 0u) << what << ", of " << samples.size();
  EXPECT_EQ(many.statistics.rays.camera, one.statistics.rays.camera) << what;
  EXPECT_EQ(many.statistics.rays.shadow, one.statistics.rays.shadow) << what;
  EXPECT_EQ(many.statistics.rays.reflection, one.statistics.rays.reflection) << what;
  EXPECT_EQ(many.statistics.rays.refraction, one.statistics.rays.refraction) << what;
  EXPECT_EQ(many.statistics.samples, one.statistics.samples) << what;
  EXPECT_EQ(many.statistics.bad_samples, one.statistics.bad_samples) << what;
}

class PacketSamples : public ::testing::TestWithParam<test::PacketScene> {};

TEST_P(PacketSamples, AreThoseTakenOneByOne) {
  for (const AccelChoice accel : searches) {
    if (GetParam().name.starts_with("footprints") && accel != AccelChoice::automatic) {
      continue;  // how rays are searched for does not show in their footprints
    }
    RenderJob job = GetParam().job;
    job.options.accel = accel;
    const RenderPlan plan = make_plan(job);
    for (const bool centres : {false, true}) {
      expect_equal(
          plan, wanted(job, centres),
          "search " + std::to_string(static_cast<int>(accel)) + (centres ? ", centres" : ""));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PacketSamples, ::testing::ValuesIn(test::packet_scenes()),
                         [](const auto& scene) {
                           std::string name = scene.param.name;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

// Any two samples may be neighbours.
TEST(PacketSample, CentresAndOthersMix) {
  const RenderJob job = test::gloss_scene();
  std::vector<PixelSample> samples = wanted(job, false);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].at_centre = i % 3 == 1;
  }
  expect_equal(make_plan(job), samples, "mixed");
}

TEST(PacketSample, SamplesFarApart) {
  const RenderJob job = test::glass_scene();
  std::vector<PixelSample> samples = wanted(job, false);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::swap(samples[i], samples[(i * 7919) % samples.size()]);
  }
  expect_equal(make_plan(job), samples, "shuffled");
}

TEST(PacketSample, WhatIsNotFiniteStaysInItsSample) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    RenderJob job = test::glass_scene();
    test::add(job, Sphere{{0.3, 1.2, 0.5}, 0.1}, {}, test::glowing({0.1, bad, 0.2}));
    RenderJob light = test::glass_scene();
    light.lights[0].colour.g = bad;
    RenderJob dark = test::coincident_scene();  // bright without end, but for shadows
    dark.lights[0].falloff = {0, 0, 0};
    for (const RenderJob& one : {job, light, dark}) {
      expect_equal(make_plan(one), wanted(one, false), "bad");
    }
  }
}

}  // namespace
}  // namespace rt
