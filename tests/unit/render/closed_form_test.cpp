// Pixels whose value is known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "rt/render/query.h"
#include "scenes.h"

namespace rt {
namespace {

using test::add;
using test::job_looking;
using test::matt;

// Film pixels are floats: relative rounding 2^-24; a handful of double roundings add nothing to it.
constexpr double film_rounding = 0x1p-23;

void expect_pixel(const Rgb& got, const Rgb& expected) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(got[k], expected[k], film_rounding * std::abs(expected[k])) << "channel " << k;
  }
}

TEST(ClosedForm, CentreOfALitSphere) {
  RenderJob job = job_looking({0, 0, 5}, {0, 0, 0}, 5, 5);
  Material m = matt({0.5, 0.25, 0.125});
  m.ks = Rgb(0.25);
  m.shininess = 10;
  m.emission = {0.01, 0.02, 0.03};
  add(job, Sphere{}, {}, m);
  job.ambient = Rgb(0.1);
  job.lights.push_back({.position = {0, 0, 9}, .colour = {1, 0.5, 2}, .falloff = {1, 0.5, 0.25}});
  // The light stands 8 above the point, straight behind the eye: n.l = r.v = 1.
  const Rgb expected = m.emission + m.kd * job.ambient +
                       (m.kd + m.ks) * Rgb(1, 0.5, 2) / (1.0 + 0.5 * 8 + 0.25 * 64);
  expect_pixel(test::pixel(test::rendered(job).film, 2, 2), expected);
}

TEST(ClosedForm, PlaneUnderAPointLight) {
  RenderJob job = job_looking({0, 4, 3}, {0, 0, 0}, 3, 3);
  add(job, Plane{}, {}, matt(Rgb(0.8)));
  job.lights.push_back({.position = {3, 4, 0}, .colour = Rgb(2.0), .falloff = {0, 0, 1}});
  // The centre ray meets the origin; the light is 5 away at cos = 4/5.
  expect_pixel(test::pixel(test::rendered(job).film, 1, 1), Rgb(0.8 * 2.0 * 0.8 / 25.0));
}

TEST(ClosedForm, ShadowEdgeFallsWhereItShould) {
  // A square at height 1 with its edge at x = 0.5, a light at (0, 3, 0): by similar triangles its
  // shadow on y = 0 ends at x = 0.75. The camera looks straight down on it.
  RenderJob job = job_looking({0.75, 10, 0}, {0.75, 0, 0}, 1000, 1);
  job.camera.up = {0, 0, -1};
  job.camera.fov = 0.001;  // 1000 pixels, each about 1.7e-4/1000 wide ... times the aspect
  add(job, Plane{}, {}, matt(Rgb(1.0)));
  add(job, Square{1.0}, Affine::translation({0, 1, 0}), matt(Rgb(1.0)));
  job.lights.push_back({.position = {0, 3, 0}});
  const Film film = test::rendered(job).film;
  // The picture's centre, between pixels 499 and 500, looks at x = 0.75 exactly.
  for (int x = 0; x < 1000; ++x) {
    const bool lit = film.pixels[3 * static_cast<std::size_t>(x)] > 0.0F;
    EXPECT_EQ(lit, x >= 500) << x;
  }
}

TEST(ClosedForm, MirrorShowsThePointThatReflectionPredicts) {
  // From (-2,1,0) over the mirror y = 0 the image of a ball at (2,1,0) is seen through the origin.
  RenderJob job = job_looking({-2, 1, 0}, {0, 0, 0}, 101, 1);
  job.camera.fov = 1e-3;
  Material mirror = matt(Rgb(0.0));
  mirror.reflectivity = {0.5, 0.25, 1};
  Material glow = matt(Rgb(0.0));
  glow.emission = {1, 1, 1};
  add(job, Plane{}, {}, mirror);
  const double radius = 1e-3;
  add(job, Sphere{{2, 1, 0}, radius}, {}, glow);
  const Film film = test::rendered(job).film;
  expect_pixel(test::pixel(film, 50, 0), mirror.reflectivity);
  // Its edge: the ball subtends asin(r / 2 sqrt(5)) on either side of the centre.
  const double per_pixel = 2.0 * std::tan(0.5e-3 * std::numbers::pi / 180.0);
  const double edge = std::tan(std::asin(radius / (2.0 * std::sqrt(5.0)))) / per_pixel;
  for (int x = 0; x < 101; ++x) {
    EXPECT_EQ(film.pixels[3 * static_cast<std::size_t>(x)] > 0.0F, std::abs(x - 50) < edge) << x;
  }
}

TEST(ClosedForm, BackgroundGradientRunsFromTopToBottom) {
  RenderJob job = job_looking({0, 0, 0}, {0, 0, -1}, 2, 4);
  job.options.background = {{1, 0, 0}, {0, 0, 1}};
  const Film film = test::rendered(job).film;
  for (int y = 0; y < 4; ++y) {
    const double f = (y + 0.5) / 4;
    expect_pixel(test::pixel(film, 1, y), {1 - f, 0, f});
  }
}

TEST(ClosedForm, DepthLimitsMirrorBounces) {
  // Two facing mirrors that also glow: bounce k adds 0.5^k.
  for (int depth : {0, 1, 5}) {
    RenderJob job = job_looking({0, 1, 0}, {0, 0, 0}, 1, 1);
    job.camera.up = {0, 0, 1};
    job.options.max_depth = depth;
    Material m = matt(Rgb(0.0));
    m.reflectivity = Rgb(0.5);
    m.emission = Rgb(1.0);
    add(job, Plane{}, {}, m);
    add(job, Plane{}, Affine::translation({0, 2, 0}), m);
    expect_pixel(test::pixel(test::rendered(job).film, 0, 0), Rgb(2.0 - std::pow(0.5, depth)));
  }
}

TEST(ClosedForm, NoLightsLeaveAmbientAlone) {
  RenderJob job = job_looking({0, 0, 5}, {0, 0, 0}, 3, 3);
  add(job, Sphere{}, {}, matt(Rgb(0.5)));
  job.ambient = {0.2, 0.4, 0.6};
  expect_pixel(test::pixel(test::rendered(job).film, 1, 1), {0.1, 0.2, 0.3});
}

TEST(ClosedForm, MirroredTransformsKeepTheirOutside) {
  // A sphere turned inside out by a negative scale is lit as any other.
  RenderJob job = job_looking({0, 0, 5}, {0, 0, 0}, 3, 3);
  add(job, Sphere{}, Affine::scaling({-1, 1, 1}), matt(Rgb(0.5)));
  job.lights.push_back({.position = {0, 0, 9}});
  expect_pixel(test::pixel(test::rendered(job).film, 1, 1), Rgb(0.5));
}

TEST(ClosedForm, ALightOnASurfaceIsNotShadowedByIt) {
  // The lamp lies in the ceiling's plane, to the last bit.
  RenderJob job = job_looking({0, 1, 0}, {0.3, 0, 0.2}, 3, 3);
  add(job, Plane{}, {}, matt(Rgb(1.0)));
  add(job, Plane{}, Affine::translation({0, 2, 0}), matt(Rgb(1.0)));
  job.lights.push_back({.position = {0.3, 2, 0.2}});
  expect_pixel(test::pixel(test::rendered(job).film, 1, 1), Rgb(1.0));
}

}  // namespace
}  // namespace rt
