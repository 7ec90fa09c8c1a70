// Samples taken several at a time are those taken one by one, bit for bit, and cost the same rays.
#include <gtest/gtest.h>

#include <algorithm>

#include "packet_scenes.h"
#include "rt/render/sample.h"

namespace rt {
namespace {

constexpr AccelChoice searches[] = {AccelChoice::automatic, AccelChoice::none, AccelChoice::list,
                                    AccelChoice::grid, AccelChoice::bvh};

/// Some samples of every pixel.
std::vector<PixelSample> wanted(const RenderJob& job) {
  std::vector<PixelSample> out;
  for (int y = 0; y < job.options.height; ++y) {
    for (int x = 0; x < job.options.width; ++x) {
      for (std::uint32_t i = 0; i < 3; ++i) {  // no multiple of the lanes
        out.push_back({x, y, i});
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
    out.values.push_back(one.take(s.x, s.y, sampler, out.statistics));
    const Vec2 u = sampler.pixel();
    out.quadrants.push_back(static_cast<std::uint8_t>((u.x < 0.5 ? 0 : 1) + (u.y < 0.5 ? 0 : 2)));
  }
  return out;
}

void expect_equal(const RenderStatistics& many, const RenderStatistics& one,
                  const std::string& what) {
  EXPECT_EQ(many.rays.camera, one.rays.camera) << what;
  EXPECT_EQ(many.rays.shadow, one.rays.shadow) << what;
  EXPECT_EQ(many.rays.reflection, one.rays.reflection) << what;
  EXPECT_EQ(many.rays.refraction, one.rays.refraction) << what;
  EXPECT_EQ(many.samples, one.samples) << what;
  EXPECT_EQ(many.bad_samples, one.bad_samples) << what;
}

void expect_equal(const RenderPlan& plan, const std::vector<PixelSample>& samples,
                  const std::string& what) {
  const Taken many = together(plan, samples);
  const Taken one = one_by_one(plan, samples);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool same =
        many.values[i] == one.values[i] && many.quadrants[i] == one.quadrants[i];
    if (!same && wrong++ == 0) {
      ADD_FAILURE() << what << ": sample " << samples[i].index << " of pixel " << samples[i].x
                    << ", " << samples[i].y;
    }
  }
  EXPECT_EQ(wrong, 0u) << what << ", of " << samples.size();
  expect_equal(many.statistics, one.statistics, what);
}

/// The centres of all pixels but some at the edges, in tiles whose edges lie anywhere.
void expect_equal_centres(const RenderPlan& plan, const std::string& what) {
  const RenderOptions& o = plan.options;
  const Crop crop{3, 1, o.width - 4, o.height - 3};
  Film many(crop.width, crop.height);
  RenderStatistics of_many;
  PixelSampler sampler(plan);
  constexpr int wide = 19;
  constexpr int high = 13;
  for (int y = crop.y; y < crop.y + crop.height; y += high) {
    for (int x = crop.x; x < crop.x + crop.width; x += wide) {
      sampler.take_centres({x, y, std::min(wide, crop.x + crop.width - x),
                            std::min(high, crop.y + crop.height - y)},
                           crop, many, of_many);
    }
  }
  Film one(crop.width, crop.height);
  RenderStatistics of_one;
  PixelSampler alone(plan);
  std::size_t wrong = 0;
  for (int y = 0; y < crop.height; ++y) {
    for (int x = 0; x < crop.width; ++x) {
      const Sampler sample(o.seed, x + crop.x, y + crop.y, 0);
      one.set(x, y, alone.take_at(x + crop.x, y + crop.y, Vec2(0.5), sample, of_one)
                        .value_or(Rgb(0.0)));
      const bool same = std::equal(one.at(x, y), one.at(x, y) + 3, many.at(x, y));
      if (!same && wrong++ == 0) {
        ADD_FAILURE() << what << ": centre of pixel " << x + crop.x << ", " << y + crop.y;
      }
    }
  }
  EXPECT_EQ(wrong, 0u) << what << ", of " << of_one.samples;
  expect_equal(of_many, of_one, what);
  EXPECT_EQ(of_many.first_bad_x, of_one.first_bad_x) << what;
  EXPECT_EQ(of_many.first_bad_y, of_one.first_bad_y) << what;
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
    const std::string search = "search " + std::to_string(static_cast<int>(accel));
    expect_equal(plan, wanted(job), search);
    expect_equal_centres(plan, search + ", centres");
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PacketSamples, ::testing::ValuesIn(test::packet_scenes()),
                         [](const auto& scene) {
                           std::string name = scene.param.name;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

// Any two samples may be neighbours.
TEST(PacketSample, SamplesFarApart) {
  const RenderJob job = test::glass_scene();
  std::vector<PixelSample> samples = wanted(job);
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
      const RenderPlan plan = make_plan(one);
      expect_equal(plan, wanted(one), "bad");
      expect_equal_centres(plan, "bad centres");
    }
  }
}

}  // namespace
}  // namespace rt
