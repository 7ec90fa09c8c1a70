// Renderings that are left off and taken up: the picture must not show it.
#include "rt/render/rendering.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace rt {
namespace {

using Clock = Deadline::Clock;

struct Mode {
  const char* name;
  void (*set)(RenderOptions&);
};

const Mode modes[] = {
    {"fixed", [](RenderOptions& o) { o.samples = 9; }},
    {"corners",
     [](RenderOptions& o) {
       o.samples = 0;
       o.aa = AntiAliasing::corners;
     }},
    {"adaptive",
     [](RenderOptions& o) {
       o.samples = 0;
       o.max_error = 0.01;
     }},
    {"progressive",
     [](RenderOptions& o) {
       o.samples = 0;
       o.max_error = 0.01;
       o.time_limit = 1e6;
     }},
    {"few samples",
     [](RenderOptions& o) {
       o.samples = 0;
       o.max_samples = 3;
     }},
};

constexpr Crop part{7, 5, 130, 100};

/// Runs for so long at a time, each time as a new rendering that takes up the bytes of the last.
RenderResult in_pieces(const RenderPlan& plan, std::chrono::microseconds piece, int& pieces) {
  std::vector<unsigned char> state;
  for (pieces = 1;; ++pieces) {
    Rendering rendering(plan, part);
    if (!state.empty()) {
      ByteReader in(state);
      rendering.load(in);
      EXPECT_TRUE(in.at_end());
    }
    if (rendering.run({}, {.pause = Clock::now() + piece})) {
      return rendering.take();
    }
    ByteWriter out;
    rendering.save(out);
    EXPECT_EQ(out.bytes().size(), rendering.state_bytes());
    state = out.take();
  }
}

TEST(Rendering, InPiecesItIsTheSame) {
  for (const Mode& mode : modes) {
    RenderJob job = test::mixed_scene(150, 110);
    mode.set(job.options);
    const RenderPlan plan = make_plan(job);
    for (const int threads : {1, 3}) {
      with_threads(threads, [&] {
        const Clock::time_point begin = Clock::now();
        const RenderResult whole = render(plan, part, {});
        const auto took = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin);
        int pieces = 0;
        const RenderResult sum = in_pieces(plan, took / 20, pieces);
        EXPECT_GT(pieces, 1) << mode.name;
        EXPECT_EQ(whole.film.pixels, sum.film.pixels) << mode.name;
        EXPECT_EQ(whole.errors, sum.errors) << mode.name;
        EXPECT_EQ(whole.samples, sum.samples) << mode.name;
        EXPECT_EQ(whole.statistics.samples, sum.statistics.samples) << mode.name;
        EXPECT_EQ(whole.statistics.rays.total(), sum.statistics.rays.total()) << mode.name;
      });
    }
  }
}

TEST(Rendering, ToldToStopItStopsAndGoesOn) {
  for (const Mode& mode : modes) {
    RenderJob job = test::mixed_scene(150, 110);
    mode.set(job.options);
    const RenderPlan plan = make_plan(job);
    const RenderResult whole = test::rendered(job);
    Rendering rendering(plan, {0, 0, 150, 110});
    std::atomic<bool> stop = true;
    EXPECT_FALSE(rendering.run({}, {.stop = &stop})) << mode.name;
    EXPECT_EQ(rendering.fraction(), 0.0);
    stop = false;
    const ProgressFunction stop_soon = [&](const Progress& p) { stop = p.fraction > 0.1; };
    EXPECT_FALSE(rendering.run(stop_soon, {.stop = &stop})) << mode.name;
    EXPECT_LT(rendering.fraction(), 0.9) << mode.name;
    EXPECT_GT(rendering.fraction(), 0.0) << mode.name;
    EXPECT_TRUE(rendering.run({}, {})) << mode.name;
    EXPECT_NEAR(rendering.fraction(), 1.0, 1e-9) << mode.name;  // a sum over a hundred tiles
    EXPECT_EQ(rendering.take().film.pixels, whole.film.pixels) << mode.name;
  }
}

TEST(Rendering, WhatATimeLimitLeftIsRefinedUnderALongerOne) {
  RenderJob job = test::mixed_scene(150, 110);
  job.options.samples = 0;
  job.options.max_error = 0.01;
  const RenderResult whole = test::rendered(job);
  job.options.time_limit = 1e-3;
  const RenderPlan brief = make_plan(job);
  Rendering first(brief, {0, 0, 150, 110});
  EXPECT_TRUE(first.run({}, {})) << "done, for its time";
  ByteWriter out;
  first.save(out);
  EXPECT_GT(first.take().reached->unreached, 0u);
  job.options.time_limit = 1e6;
  const RenderPlan longer = make_plan(job);
  Rendering second(longer, {0, 0, 150, 110});
  ByteReader in(out.bytes());
  second.load(in);
  EXPECT_TRUE(second.run({}, {}));
  EXPECT_EQ(second.take().film.pixels, whole.film.pixels);
}

/// Whatever the bytes, loading them gives an error or a rendering that can be finished.
TEST(Rendering, DamagedBytesDoNoHarm) {
  RenderJob job = test::mixed_scene(40, 30);
  job.options.samples = 0;
  job.options.max_samples = 64;
  job.options.time_limit = 1e-3;
  const RenderPlan plan = make_plan(job);
  const Crop all{0, 0, 40, 30};
  Rendering rendering(plan, all);
  rendering.run({}, {});
  ByteWriter out;
  rendering.save(out);
  const std::vector<unsigned char> good = out.take();
  std::uint64_t random = 1;
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<unsigned char> bad = good;
    for (int flips = 0; flips < 1 + i % 4; ++flips) {
      random = mix64(random + golden64);
      bad[random % bad.size()] = static_cast<unsigned char>(random >> 56);
    }
    bad.resize(i % 7 == 0 ? random % bad.size() : bad.size());
    Rendering other(plan, all);
    try {
      ByteReader in(bad);
      other.load(in);
      other.run({}, {});
    } catch (const std::out_of_range&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 400);  // every seventh is cut short
}

}  // namespace
}  // namespace rt
