// One pixel: its filter, its lens, the classic scheme.
#include <gtest/gtest.h>

#include <cmath>

#include "rt/math/warp.h"
#include "scenes.h"

namespace rt {
namespace {

constexpr double size = 32.0;

/// A bright half-space x < edge (in pixels from the left), seen head on from distance 1: the
/// picture is one unit high and wide. Thin, so that a lens does not see its side.
RenderJob half_plane(double edge, double distance = 1.0) {
  RenderJob job =
      test::job_looking({0, 0, 0}, {0, 0, -1}, static_cast<int>(size), static_cast<int>(size));
  job.camera.fov = 2.0 * std::atan(0.5) * 180.0 / pi;
  Material bright;
  bright.kd = Rgb(0.0);
  bright.emission = Rgb(1.0);
  const double x = (edge / size - 0.5) * distance;
  test::add(job,
            Box{Vec3(x - 100.0 * distance, -100.0 * distance, -distance * (1.0 + 1e-9)),
                Vec3(x, 100.0 * distance, -distance)},
            {}, bright);
  return job;
}

/// What a filter gives of a half-plane whose edge lies so far right of the pixel's centre.
double filtered(Filter filter, double edge) {
  constexpr int n = 400;
  const double r = filter_radius(filter);
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vec2 at{r * ((i + 0.5) * 2.0 / n - 1.0), r * ((j + 0.5) * 2.0 / n - 1.0)};
      sum += at.x < edge ? filter_density(filter, at) * 4.0 * r * r / (n * n) : 0.0;
    }
  }
  return sum;
}

TEST(Pixel, EdgesAreFilteredAsTheFilterSays) {
  for (const Filter filter :
       {Filter::box, Filter::tent, Filter::gaussian, Filter::blackman_harris}) {
    RenderJob job = half_plane(16.3);
    job.options.samples = 4096;
    job.options.filter = filter;
    const Film film = test::rendered(job).film;
    for (int x = 13; x < 20; ++x) {
      EXPECT_NEAR(test::pixel(film, x, 9).r, filtered(filter, 16.3 - (x + 0.5)), 0.004)
          << static_cast<int>(filter) << ' ' << x;
    }
  }
}

TEST(Pixel, OneSampleIsThePixelsCentre) {
  for (const double edge : {16.49, 16.51}) {
    const Film film = test::rendered(half_plane(edge)).film;
    EXPECT_EQ(test::pixel(film, 16, 9).r, edge > 16.5 ? 1.0 : 0.0);
  }
}

// An edge at distance d, the plane in focus at f: from the lens' point p the edge is seen moved by
// p (1 - d/f). What a pixel sees is the share of the lens with x + p.x (1 - d/f) / d < edge.
TEST(Pixel, ALensBlursAnEdgeByItsCircleOfConfusion) {
  const double d = 2.0;
  const double f = 1.25;
  const double radius = 0.1;
  RenderJob job = half_plane(16.3, d);
  job.camera.aperture = 2.0 * radius;
  job.camera.focus = f;
  job.options.filter = Filter::box;
  job.options.samples = 4096;
  const Film film = test::rendered(job).film;
  const double confusion = radius * std::abs(1.0 - d / f) / d * size;  // pixels
  ASSERT_GT(confusion, 0.9);
  for (int x = 13; x < 20; ++x) {
    double expected = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double s = std::clamp((16.3 - (x + (i + 0.5) / 1000.0)) / confusion, -1.0, 1.0);
      expected += (1.0 - (std::acos(s) - s * std::sqrt(1.0 - s * s)) / pi) / 1000.0;
    }
    EXPECT_NEAR(test::pixel(film, x, 9).r, expected, 0.004) << x;
  }
  // In focus there is no blur.
  job.camera.focus = d;
  job.options.samples = 64;
  EXPECT_EQ(test::pixel(test::rendered(job).film, 15, 9).r, 1.0);
  EXPECT_EQ(test::pixel(test::rendered(job).film, 17, 9).r, 0.0);
}

TEST(Corners, DivideAlongEdgesOnly) {
  RenderJob job = half_plane(16.3);
  job.options.samples = 0;
  job.options.aa = AntiAliasing::corners;
  const RenderResult result = test::rendered(job);
  EXPECT_EQ(test::pixel(result.film, 15, 9).r, 1.0);
  EXPECT_EQ(test::pixel(result.film, 17, 9).r, 0.0);
  // 2^-5 of a pixel is as fine as it looks.
  EXPECT_NEAR(test::pixel(result.film, 16, 9).r, 0.3, 1.0 / 32.0);
  EXPECT_LT(result.statistics.samples, 10'000u);
  EXPECT_FALSE(result.reached.has_value());
}

TEST(Corners, BytesDoNotDependOnTheCrop) {
  RenderJob job = test::mixed_scene(50, 40);
  job.options.samples = 0;
  job.options.aa = AntiAliasing::corners;
  job.lights[0].radius = 0.5;
  const Film full = test::rendered(job, 2).film;
  const Film part = render(make_plan(job), {11, 5, 20, 30}, {}).film;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 20; ++x) {
      ASSERT_EQ(test::pixel(part, x, y), test::pixel(full, x + 11, y + 5));
    }
  }
}

}  // namespace
}  // namespace rt
