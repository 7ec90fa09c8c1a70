// Filtering of checkers and noise: what is smaller than a sample becomes its mean.
#include <gtest/gtest.h>

#include <iterator>
#include <numeric>
#include <random>

#include "pictures.h"
#include "probe.h"
#include "rt/scene/wide_texture.h"

namespace rt {
namespace {

using test::add;
using test::bare_job;
using test::job_looking;
using test::matt;
using test::paint;
using test::rendered;

struct Moments {
  double mean, deviation;
};

/// Of the red channel over rows [from, to).
Moments moments(const Film& film, int from, int to) {
  double sum = 0;
  double squares = 0;
  for (int y = from; y < to; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const double v = test::pixel(film, x, y).r;
      sum += v;
      squares += v * v;
    }
  }
  const double n = 1.0 * (to - from) * film.width;
  return {sum / n, std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)))};
}

TEST(Checker, MeanOverABoxIsExact) {
  const Checker checker{Rgb(1.0), Rgb(0.0), 0.5};
  const auto even = [&](const Vec3& p, const Vec3& w) { return colour(checker, p, w).r; };
  EXPECT_EQ(even({0.1, 0.1, 0.1}, Vec3(0.0)), 1.0);
  EXPECT_EQ(even({-0.1, 0.1, 0.1}, Vec3(0.0)), 0.0);
  EXPECT_EQ(even({0.25, 0.1, 0.1}, {0.4, 0, 0}), 1.0);          // within the cell
  EXPECT_NEAR(even({0.5, 0.1, 0.1}, {0.4, 0, 0}), 0.5, 1e-14);  // astride a wall
  EXPECT_NEAR(even({0.6, 0.1, 0.1}, {0.4, 0, 0}), 0.25, 1e-12);
  EXPECT_NEAR(even({0.3, 0.1, 0.1}, {1.0, 0, 0}), 0.5, 1e-12);  // a period
  EXPECT_NEAR(even({0.25, 0.1, 0.1}, {1.5, 0, 0}), 1.0 / 3.0, 1e-12);
  // Against the mean of many points, in all three axes at once, near the origin and far from it.
  for (const double far : {0.0, -7e3, 1e9}) {
    const Vec3 p(far + 0.13, 0.71, -0.36);
    const Vec3 w(0.9, 1.7, 0.3);
    double sum = 0;
    const int n = 120;
    for (int i = 0; i < n * n * n; ++i) {
      const Vec3 u((i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / n / n + 0.5) / n);
      sum += even(p + (u - 0.5) * w, Vec3(0.0));
    }
    // Walls fall inside cells of the sum: each axis is right to 1 / n of a cell and its period.
    EXPECT_NEAR(even(p, w), sum / (n * n * n), 3.0 / n) << far;
  }
}

TEST(Checker, GivesFiniteMeansOverAnyBox) {
  const Checker checker{Rgb(0.8), Rgb(0.2), 1e-3};
  for (const double p : {0.0, 0.3, 1e15, -1e300}) {
    for (const double w :
         {1e-300, 1e-12, 1.0, 1e18, 1e300, std::numeric_limits<double>::infinity()}) {
      const Rgb c = colour(checker, Vec3(p), Vec3(w));
      EXPECT_GE(c.r, 0.2 - 1e-9) << p << " " << w;
      EXPECT_LE(c.r, 0.8 + 1e-9) << p << " " << w;
    }
  }
  EXPECT_NEAR(colour(checker, Vec3(0.3), Vec3(1e6)).r, 0.5, 1e-6);
}

// Bit for bit, on walls and corners of cells, far away, over boxes of any size, and over none.
TEST(Checker, OfSeveralPointsIsThatOfEach) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const Checker checker{{0.8, 0.1, 0.3}, {0.2, 0.7, 0.1}, 0.3};
  const double places[] = {0.0,  0.3, -0.3, std::nextafter(0.6, 0.0), 0.4517, -7.93,
                           1e9,  -3e15, 1e300, inf, NAN};
  const double widths[] = {0.0, 1e-9, 0.05, 0.3, 0.6, 17.3, 1e12, 1e300, inf, NAN};
  std::mt19937 random(5);
  const auto any = [&](const auto& list) { return list[random() % std::size(list)]; };
  for (int k = 0; k < 2000; ++k) {
    Wide3 p;
    Wide3 width;
    for (int i = 0; i < lanes; ++i) {
      p.set(i, {any(places), any(places), any(places)});
      width.set(i, {any(widths), any(widths), any(widths)});
    }
    const Wide3 all = colour(checker, p, width);
    for (int i = 0; i < lanes; ++i) {
      const Rgb one = colour(checker, p.lane(i), width.lane(i));
      for (int c = 0; c < 3; ++c) {
        const double lane = all.lane(i)[c];
        ASSERT_TRUE(lane == one[c] || (std::isnan(lane) && std::isnan(one[c])));
      }
    }
  }
}

TEST(Checker, DoesNotSpeckleWhereAFaceLiesOnAWallOfCells) {
  // The top of a cube that is one cell: it lies on the wall to the next, which it belongs to.
  RenderJob job = job_looking({0, 30, 1}, {0, 0, 0}, 60, 60);
  job.ambient = Rgb(1.0);
  add(job, Box{},
      Affine::rotation(1, 37) * Affine::scaling({7, 3.3, 7}) * Affine::translation({-0.5, 0, -0.5}),
      matt(Rgb(1.0)));
  paint(job, Checker{Rgb(1.0), Rgb(0.25), 1.0});
  for (const bool filter : {true, false}) {
    job.options.texture_filter = filter;
    const Film film = rendered(job).film;
    for (int y = 25; y < 35; ++y) {
      for (int x = 25; x < 35; ++x) {
        EXPECT_EQ(test::pixel(film, x, y), Rgb(0.25)) << x << " " << y;
      }
    }
  }
}

/// Cells of 1/50 over ground seen from above: some 5 of them a pixel, at one sample each.
RenderJob minified() {
  RenderJob job = job_looking({0.3, 20, 3.7}, {0, 0, 0}, 100, 100);
  job.ambient = Rgb(1.0);
  add(job, Plane{}, Affine::rotation(1, 23), matt(Rgb(1.0)));
  paint(job, Checker{Rgb(1.0), Rgb(0.0), 0.02});
  return job;
}

TEST(Checker, MinifiedIsMidGreyAtOneSampleAPixel) {
  RenderJob job = minified();
  const Moments filtered = moments(rendered(job).film, 0, 100);
  EXPECT_NEAR(filtered.mean, 0.5, 0.01);
  EXPECT_LT(filtered.deviation, 0.02);
  job.options.texture_filter = false;
  const Moments unfiltered = moments(rendered(job).film, 0, 100);
  EXPECT_GT(unfiltered.deviation, 0.4);  // black and white
}

/// A checker to the horizon, which lies between rows 39 and 40 of 80.
RenderJob horizon() {
  RenderJob job = job_looking({0.3, 1.5, 0}, {0.3, 1.5, -1}, 120, 80);
  job.camera.fov = 50;
  job.ambient = Rgb(1.0);
  job.options.background = {Rgb(0.5), Rgb(0.5)};
  add(job, Plane{}, Affine::rotation(1, 11), matt(Rgb(1.0)));
  paint(job, Checker{Rgb(1.0), Rgb(0.0), 0.5});
  return job;
}

TEST(Checker, ConvergesToGreyTowardsTheHorizonWithoutMoire) {
  RenderJob job = horizon();
  job.options.samples = 0;
  job.options.max_error = 0.01;
  const Film film = rendered(job, 2).film;
  // Row 40 + k sees the ground at 1.5 / ((k + 1/2) pixel) with pixel = 0.01166, so that a sample of
  // half a pixel spans a period (1) of depth at k = 7 and more above.
  for (int row = 40; row < 44; ++row) {
    const Moments m = moments(film, row, row + 1);
    EXPECT_NEAR(m.mean, 0.5, 0.01) << row;
    EXPECT_LT(m.deviation, 0.02) << row;
  }
  const Moments m = moments(film, 40, 47);
  EXPECT_NEAR(m.mean, 0.5, 0.01);
  // Nearby it is a checker still.
  EXPECT_GT(moments(film, 70, 80).deviation, 0.4);
  // The unfiltered one at a sample a pixel is noise there.
  job.options.samples = 1;
  job.options.texture_filter = false;
  EXPECT_GT(moments(rendered(job).film, 40, 44).deviation, 0.4);
}

NoiseTexture noise_of(NoiseKind kind) {
  NoiseTexture t;
  t.kind = kind;
  t.octaves = {{1.0, 1.0}, {2.3, 0.5}};
  t.ramp = {{0.0, Rgb(0.0)}, {0.45, Rgb(0.1)}, {0.55, Rgb(0.9)}, {1.0, Rgb(1.0)}};
  t.noise = std::make_shared<const Noise>(5);
  return t;
}

TEST(NoiseTexture, FadesToItsMeanColourThroughTheRamp) {
  for (const NoiseKind kind :
       {NoiseKind::fbm, NoiseKind::turbulence, NoiseKind::marble, NoiseKind::wood}) {
    const NoiseTexture texture = noise_of(kind);
    double sum = 0;
    const int n = 60;
    for (int i = 0; i < n * n * n; ++i) {
      const Vec3 p = 0.37 * Vec3(i % n, i / n % n, i / n / n) + Vec3(0.11, 0.05, 0.21);
      sum += colour(texture, p, Vec3(0.0), Vec3(0.0)).r;
    }
    const Rgb faded = colour(texture, {0.3, 0.2, 0.1}, {50, 0, 0}, {0, 0, 50});
    // What is lost is taken for evenly spread; its true distribution is rounder.
    EXPECT_NEAR(faded.r, sum / (n * n * n), 0.06) << static_cast<int>(kind);
    const HeightSample flat = height(texture, {0.3, 0.2, 0.1}, {50, 0, 0}, {0, 0, 50});
    EXPECT_EQ(flat.gradient, Vec3(0.0));
    EXPECT_NEAR(flat.value, faded.r, 1e-12);
  }
}

TEST(NoiseTexture, TakesALongFootprintInParts) {
  // Half a cell wide and 2 long: as one square of the longer edge all would be lost.
  NoiseTexture texture = noise_of(NoiseKind::fbm);
  texture.octaves = {{1.0, 1.0}};
  texture.ramp = {{0.0, Rgb(0.0)}, {1.0, Rgb(1.0)}};
  const Vec3 p(0.3, 0.4, 0.2);
  const double whole = colour(texture, p, {0, 2, 0}, {0, 0, 2}).r;
  const double parts = colour(texture, p, {0, 2, 0}, {0, 0, 0.5}).r;
  double mean = 0;
  for (int i = 0; i < 4; ++i) {
    mean += 0.25 * colour(texture, p + Vec3(0, -0.75 + 0.5 * i, 0), Vec3(0.0), Vec3(0.0)).r;
  }
  EXPECT_NEAR(whole, 0.5, 1e-12);
  EXPECT_NEAR(parts, mean, 1e-12);
  EXPECT_GT(std::abs(parts - whole), 1e-3);
}

TEST(NoiseTexture, GradientIsThatOfTheHeight) {
  for (const NoiseKind kind :
       {NoiseKind::fbm, NoiseKind::turbulence, NoiseKind::marble, NoiseKind::wood}) {
    const NoiseTexture texture = noise_of(kind);
    for (const double width : {0.0, 0.3}) {
      const Vec3 dx(width, 0, 0);
      const Vec3 dy(0, width, 0);
      const Vec3 p(1.37, 2.21, -0.83);
      const Vec3 g = height(texture, p, dx, dy).gradient;
      for (int i = 0; i < 3; ++i) {
        Vec3 step(0.0);
        step[i] = 1e-6;
        const double d =
            (height(texture, p + step, dx, dy).value - height(texture, p - step, dx, dy).value) /
            2e-6;
        EXPECT_NEAR(g[i], d, 1e-5 * (1 + std::abs(d))) << static_cast<int>(kind) << " " << width;
      }
    }
  }
}

/// Everything at once: checker, noise, bumps, pictures, through mirrors and gloss.
RenderJob painted_scene() {
  RenderJob job = test::mixed_scene(64, 48);
  const Texture noise = noise_of(NoiseKind::marble);
  for (std::size_t i = 0; i < job.instances.size(); ++i) {
    auto set = std::make_shared<TextureSet>();
    const Texture picture = test::formula(
        [](const Vec2& uv) { return Rgb(0.5 + 0.5 * std::sin(40 * uv.x), uv.y, 0.3); });
    const Texture chosen = i % 3 == 0 ? Texture(Checker{}) : i % 3 == 1 ? noise : picture;
    (*set)[TextureSlot::kd].texture = std::make_shared<const Texture>(chosen);
    (*set)[TextureSlot::bump] = {std::make_shared<const Texture>(noise), 0.03};
    Instance painted = job.instances[i];
    painted.textures = set;
    job.instances.replace(i, painted);
  }
  job.options.samples = 0;
  return job;
}

TEST(Texture, IsTheSameForAnyThreadsAndCrop) {
  const RenderJob job = painted_scene();
  const Film one = rendered(job, 1).film;
  EXPECT_EQ(one.pixels, rendered(job, 8).film.pixels);
  const Crop crop{13, 7, 20, 30};
  const Film part = render(make_plan(job), crop, {}).film;
  for (int y = 0; y < crop.height; ++y) {
    for (int x = 0; x < crop.width; ++x) {
      ASSERT_EQ(test::pixel(part, x, y), test::pixel(one, x + crop.x, y + crop.y));
    }
  }
}

}  // namespace
}  // namespace rt
