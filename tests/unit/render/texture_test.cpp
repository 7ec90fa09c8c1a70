// What textures give where: positions on every shape, what they drive, and filtering.
#include <gtest/gtest.h>

#include "pictures.h"
#include "probe.h"

namespace rt {
namespace {

using test::add;
using test::bare_job;
using test::matt;
using test::paint;
using test::Probe;

const double pi_ = std::numbers::pi;

RenderJob lit_evenly() {
  RenderJob job = bare_job();
  job.ambient = Rgb(1.0);
  return job;
}

/// Looks from `from` along `to - from` at a shape painted with its own coordinates.
void expect_uv(const Shape& shape, const Vec3& from, const Vec3& to, const Vec2& uv,
               const Affine& placed = {}) {
  RenderJob job = lit_evenly();
  add(job, shape, placed, matt(Rgb(1.0)));
  paint(job, test::coordinates_picture());
  const Rgb seen = Probe(job)(placed.point(from), placed.vector(to - from));
  EXPECT_NEAR(seen.r, uv.x, 1e-12) << shape_kind(shape);
  EXPECT_NEAR(seen.g, uv.y, 1e-12) << shape_kind(shape);
}

Vec3 around(double longitude, double y, double rho) {
  return {rho * std::cos(longitude), y, rho * std::sin(longitude)};
}

TEST(Texture, LiesWhereTheClosedFormSaysOnEveryShape) {
  const Affine moved = Affine::translation({3, -2, 5}) * Affine::rotation(0, 33) *
                       Affine::rotation(1, 71) * Affine::scaling({2, 0.5, 1.25});
  for (const Affine& placed : {Affine{}, moved}) {
    for (const double turn : {0.05, 0.3, 0.62, 0.97}) {
      const double a = 2 * pi_ * turn;
      const double latitude = 0.7;
      const Vec3 on = around(a, std::sin(latitude), std::cos(latitude));
      expect_uv(Sphere{}, 5.0 * on, on, {turn, 0.5 + latitude / pi_}, placed);
      expect_uv(Sphere{{1, 2, 3}, 2}, Vec3(1, 2, 3) + 9.0 * on, Vec3(1, 2, 3) + on,
                {turn, 0.5 + latitude / pi_}, placed);
      expect_uv(Blob{}, 5.0 * on, on, {turn, 0.5 + latitude / pi_}, placed);
      expect_uv(Cylinder{}, around(a, 0.3, 4), around(a, 0.3, 1), {turn, 0.3}, placed);
      expect_uv(PointedCone{}, around(a, 0.3, 4), around(a, 0.3, 0.7), {turn, 0.3}, placed);
      expect_uv(Capsule{1, 0.5}, around(a, 0.3, 4), around(a, 0.3, 0.5),
                {turn, (0.25 * pi_ + 0.3) / (0.5 * pi_ + 1)}, placed);
      const double b = 2 * pi_ * 0.2;  // on the tube, outside and above
      const auto tube = [&](double r) { return around(a, r * std::sin(b), 1 + r * std::cos(b)); };
      expect_uv(Torus{}, tube(2), tube(0.25), {turn, 0.2}, placed);
    }
    expect_uv(Cylinder{}, {0.3, 3, 0.4}, {0.3, 1, 0.4}, {0.65, 0.3}, placed);
    expect_uv(Square{4}, {1, 3, 0.5}, {1, 0, 0.5}, {0.75, 0.375}, placed);
    expect_uv(Plane{}, {1.25, 3, -0.5}, {1.25, 0, -0.5}, {1.25, 0.5}, placed);
    expect_uv(Box{}, {0.2, 0.7, 5}, {0.2, 0.7, 1}, {0.2, 0.7}, placed);   // front
    expect_uv(Box{}, {0.2, 0.7, -5}, {0.2, 0.7, 0}, {0.8, 0.7}, placed);  // back
    expect_uv(Box{}, {0.2, 5, 0.3}, {0.2, 1, 0.3}, {0.2, 0.7}, placed);   // top
    expect_uv(Box{}, {5, 0.7, 0.3}, {1, 0.7, 0.3}, {0.7, 0.7}, placed);   // right
    auto data = std::make_shared<MeshData>();
    data->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    data->triangles = data->triangle_uvs = {{0, 1, 2}};
    data->uvs = {{0.25, 0.5}, {0.75, 0.5}, {0.25, 1.0}};
    expect_uv(Mesh{data}, {0.2, 0.4, 3}, {0.2, 0.4, 0}, {0.35, 0.7}, placed);
  }
}

TEST(Texture, RepeatsAsItsScaleSays) {
  RenderJob job = lit_evenly();
  add(job, Square{2}, Affine::translation({0, -1, 0}), matt(Rgb(1.0)));
  paint(job, test::formula([](const Vec2& uv) { return Rgb(uv.x, uv.y, 0); }, {3, 5}));
  const Rgb seen = Probe(job)({0, 0, 0}, {0.5, -1, -0.25});
  EXPECT_NEAR(seen.r, 3 * 0.75, 1e-12);
  EXPECT_NEAR(seen.g, 5 * 0.625, 1e-12);
}

TEST(Texture, IsAskedForTheAreaOfASample) {
  // Straight down from a height of 3 at a square of edge 2: a pixel's side over the square's.
  RenderJob job = lit_evenly();
  job.options.width = job.options.height = 50;
  job.camera.fov = 60;
  add(job, Square{2}, Affine::translation({0, 0, -3}) * Affine::rotation(0, 90), matt(Rgb(1.0)));
  paint(job, ImageTexture{std::make_shared<const test::FootprintImage>(), {1, 4}});
  const double pixel = 3 * 2 * std::tan(pi_ / 6) / 50 / 2;
  const Rgb seen = Probe(job)({0, 0, 0}, {0, 0, -1});
  EXPECT_NEAR(seen.r, pixel, 1e-12);
  EXPECT_NEAR(seen.g, 4 * pixel, 1e-12);
  job.options.samples = 16;
  EXPECT_NEAR(Probe(job)({0, 0, 0}, {0, 0, -1}).r, pixel / 4, 1e-12);
  job.options.texture_filter = false;
  EXPECT_EQ(Probe(job)({0, 0, 0}, {0, 0, -1}), Rgb(0.0));
}

TEST(Texture, HasASmoothFootprintAcrossTheSeamAndNearThePoles) {
  RenderJob job = lit_evenly();
  job.options.width = job.options.height = 100;
  add(job, Sphere{}, Affine::translation({0, 0, -5}) * Affine::rotation(1, 90), matt(Rgb(1.0)));
  paint(job, ImageTexture{std::make_shared<const test::FootprintImage>()});
  Probe probe(job);
  const Rgb left = probe({0, 0, 0}, {-1e-9, 0.1, -5});
  const Rgb right = probe({0, 0, 0}, {1e-9, 0.1, -5});
  EXPECT_LT(max_abs(left - right), 1e-6);
  EXPECT_LT(left.r, 0.05);  // no jump of a whole turn
  // From above the pole: all of u at once, but v as anywhere.
  RenderJob above = lit_evenly();
  above.options.width = above.options.height = 100;
  add(above, Sphere{}, Affine::translation({0, 0, -5}) * Affine::rotation(0, 90), matt(Rgb(1.0)));
  paint(above, ImageTexture{std::make_shared<const test::FootprintImage>()});
  for (const double off : {0.0, 1e-12, 1e-6}) {
    const Rgb pole = Probe(above)({0, 0, 0}, {off, 0, -1});
    EXPECT_GE(pole.r, 1.0);
    EXPECT_LT(pole.g, 0.05);
  }
}

TEST(Texture, DrivesHighlights) {
  RenderJob job = bare_job();
  Material shiny = matt(Rgb(0.0));
  shiny.ks = Rgb(0.0);
  shiny.shininess = 10;
  add(job, Square{100}, Affine::translation({0, 0, -2}) * Affine::rotation(0, 90), shiny);
  job.lights.push_back({.position = {0, 0, 0}, .colour = Rgb(1.0)});
  EXPECT_EQ(Probe(job)({0, 0, 0}, {0, 0, -1}), Rgb(0.0));
  paint(job, test::formula([](const Vec2&) { return Rgb(0.25, 0.5, 0.75); }), TextureSlot::ks);
  const Rgb seen = Probe(job)({0, 0, 0}, {0, 0, -1});
  EXPECT_NEAR(seen.r, 0.25, 1e-12);
  EXPECT_NEAR(seen.b, 0.75, 1e-12);
}

/// A sheet at y = 1 whose opacity is 1 in even cells, 0 in odd ones, over a floor at y = 0.
RenderJob perforated() {
  RenderJob job = bare_job();
  job.options.width = job.options.height = 1000;  // samples much narrower than cells
  add(job, Plane{}, {}, matt(Rgb(1.0)));
  add(job, Square{100}, Affine::translation({0, 1, 0}), matt(Rgb(0.0)));
  paint(job, Checker{Rgb(1.0), Rgb(0.0), 1.0}, TextureSlot::opacity);
  job.lights.push_back({.position = {0.5, 1000, 0.5}, .colour = Rgb(1.0)});
  return job;
}

TEST(Texture, OfOpacityCutsHolesForEyesAndLights) {
  RenderJob job = perforated();
  Probe probe(job);
  // Through a hole the lit floor, through none the sheet.
  EXPECT_NEAR(probe({1.5, 5, 0.5}, {0, -1, 0}).r, 1.0, 1e-5);
  EXPECT_EQ(probe({0.5, 5, 0.5}, {0, -1, 0}).r, 0.0);
  // From below the sheet: its shadow.
  EXPECT_EQ(probe({0.5, 0.5, 0.5}, {0, -1, 0}).r, 0.0);
  EXPECT_NEAR(probe({1.5, 0.5, 0.5}, {0, -1, 0}).r, 1.0, 1e-5);
  EXPECT_TRUE(probe.plan().dims);
  job.options.refraction = false;
  EXPECT_FALSE(make_plan(job).dims);
}

TEST(Texture, IsLeftOutByItsSwitch) {
  RenderJob job = lit_evenly();
  add(job, Square{100}, Affine::translation({0, 0, -2}) * Affine::rotation(0, 90), matt(Rgb(0.5)));
  paint(job, Checker{Rgb(1.0), Rgb(1.0), 1.0});
  const auto seen = [&] { return Probe(job)({0, 0, 0}, {0.1, 0.2, -1}).r; };
  EXPECT_EQ(seen(), 1.0);
  job.options.noise = false;
  EXPECT_EQ(seen(), 1.0);
  job.options.textures = false;
  EXPECT_EQ(seen(), 0.5);
  NoiseTexture noise;
  noise.ramp = {{0.0, Rgb(0.9)}};
  noise.noise = std::make_shared<const Noise>();
  paint(job, noise);
  EXPECT_EQ(seen(), 0.5);
  job.options.noise = true;
  EXPECT_NEAR(seen(), 0.9, 1e-15);
}

}  // namespace
}  // namespace rt
