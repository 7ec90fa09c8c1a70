// What media, opacity and glass in a light's way take from it; and things that shine.
#include <gtest/gtest.h>

#include "probe.h"

namespace rt {
namespace {

using test::add;
using test::bare_job;
using test::fresnel_by_angles;
using test::glass;
using test::glowing;
using test::matt;
using test::Probe;

// Some tens of roundings.
constexpr double rounding = 1e-13;

void expect_rgb(const Rgb& got, const Rgb& expected) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(got[k], expected[k], rounding * (1.0 + std::abs(expected[k]))) << "channel " << k;
  }
}

const Rgb absorption{0.5, 1.0, 0.25};

/// A tinted medium of index 1: no reflection, no bending.
Material tinted() {
  Material m = glass(1.0);
  m.absorption = absorption;
  return m;
}

const Vec3 ahead{0, 0, -1};
const Vec3 slanted = glm::normalize(Vec3(0.2, 0.1, -1));

RenderJob before(const Rgb& background) {
  RenderJob job = bare_job();
  job.options.background = {background, background};
  return job;
}

TEST(Absorption, FallsExponentiallyWithThePathThroughABox) {
  RenderJob job = before({1, 0.5, 2});
  add(job, Box{{-5, -5, -4}, {5, 5, -2}}, {}, tinted());
  expect_rgb(Probe(job)({0, 0, 0}, slanted),
             Rgb(1, 0.5, 2) * glm::exp(-absorption * (2.0 / -slanted.z)));
  // A ray of any length, and a box of any scale: distances are the world's.
  expect_rgb(Probe(job)({0, 0, 0}, 1e-3 * slanted),
             Rgb(1, 0.5, 2) * glm::exp(-absorption * (2.0 / -slanted.z)));
  RenderJob scaled = before(Rgb(1.0));
  add(scaled, Box{}, Affine::translation({-5, -5, -4}) * Affine::scaling({10, 10, 2}), tinted());
  expect_rgb(Probe(scaled)({0, 0, 0}, slanted), glm::exp(-absorption * (2.0 / -slanted.z)));
}

TEST(Absorption, FallsExponentiallyWithTheChordOfASphere) {
  for (const double height : {0.0, 0.3, 0.9, 0.999}) {
    RenderJob job = before(Rgb(1.0));
    add(job, Sphere{{0, 0, -4}, 1}, {}, tinted());
    const double chord = 2.0 * std::sqrt(1.0 - height * height);
    expect_rgb(Probe(job)({0, height, 0}, ahead), glm::exp(-absorption * chord));
  }
}

TEST(Absorption, WithReflectionsInsideIsAGeometricSeries) {
  // Straight through a slab of thickness d: T = (1-F)^2 A / (1 - F^2 A^2), A = exp(-a d).
  RenderJob job = before(Rgb(1.0));
  Material m = tinted();
  m.ior = 1.8;
  add(job, Box{{-5, -5, -4}, {5, 5, -2}}, {}, m);
  // A black wall behind the eye: what the slab reflects brings nothing back.
  add(job, Square{50.0}, Affine::translation({0, 0, 1}) * Affine::rotation(0, 90), matt(Rgb(0.0)));
  const double f = fresnel_by_angles(1.0, 1.0, 1.8);
  const Rgb a = glm::exp(-absorption * 2.0);
  expect_rgb(Probe(job)({0, 0, 0}, ahead), (1 - f) * (1 - f) * a / (Rgb(1.0) - f * f * a * a));
}

TEST(Absorption, TintsWhatStandsInside) {
  RenderJob job = bare_job();
  add(job, Sphere{{0, 0, -4}, 2}, {}, tinted());
  add(job, Sphere{{0, 0, -4}, 0.5}, {}, glowing({1, 2, 3}));
  expect_rgb(Probe(job)({0, 0, 0}, ahead), Rgb(1, 2, 3) * glm::exp(-absorption * 1.5));
  // A bubble around it takes its share of the way out.
  add(job, Sphere{{0, 0, -4}, 1}, {}, glass(1.0));
  expect_rgb(Probe(job)({0, 0, 0}, ahead), Rgb(1, 2, 3) * glm::exp(-absorption * 1.0));
  // And from an eye inside the medium.
  expect_rgb(Probe(job)({0, 0, -2.5}, ahead), Rgb(1, 2, 3) * glm::exp(-absorption * 0.5));
}

TEST(Absorption, DimsShadowRays) {
  // A light 4 above a floor, a tinted box of thickness 1 between, pierced obliquely.
  RenderJob job = bare_job();
  add(job, Plane{}, Affine::translation({0, -1, 0}), matt(Rgb(1.0)));
  add(job, Box{{-9, 0.5, -9}, {9, 1.5, 9}}, {}, tinted());
  job.lights.push_back({.position = {3, 3, -2}});
  const double cosine = 4.0 / 5.0;  // seen from (0, -1, -2)
  const Vec3 origin{0, 0, -1};
  const Vec3 way{0, -1, -1};
  expect_rgb(Probe(job)(origin, way), cosine * glm::exp(-absorption * (1.0 / cosine)));
}

TEST(Absorption, DimsALightInsideTheMedium) {
  // Floor and light in one tinted box; then the light alone.
  RenderJob job = bare_job();
  add(job, Plane{}, Affine::translation({0, -1, 0}), matt(Rgb(1.0)));
  add(job, Box{{-9, -2, -9}, {9, 9, -1}}, {}, tinted());
  job.lights.push_back({.position = {0, 1, -3}});
  // The eye's ray enters the box at z = -1 and goes sqrt(2) x 2 to the floor at (0, -1, -3).
  const Vec3 origin{0, 2, 0};
  const Vec3 way{0, -1, -1};
  expect_rgb(Probe(job)(origin, way),
             glm::exp(-absorption * (2.0 * std::sqrt(2.0))) * glm::exp(-absorption * 2.0));
  RenderJob lamp = bare_job();
  add(lamp, Plane{}, Affine::translation({0, -1, 0}), matt(Rgb(1.0)));
  add(lamp, Sphere{{0, 3, -3}, 1}, {}, tinted());
  lamp.lights.push_back({.position = {0, 3.25, -3}});
  expect_rgb(Probe(lamp)(origin, way), glm::exp(-absorption * 1.25));
}

TEST(Absorption, ShadowsPassASurfaceHiddenInAnotherSolid) {
  // Tinted water, half covering a clear ball: under the ball's lower half its chord is clear.
  RenderJob job = bare_job();
  Material water = tinted();
  water.opacity = 0.25;
  add(job, Plane{}, Affine::translation({0, -3, 0}), matt(Rgb(1.0)));
  add(job, Box{{-9, -9, -9}, {9, 0, 9}}, {}, water);
  add(job, Sphere{{0, 0, -4}, 1}, {}, glass(1.0));
  job.lights.push_back({.position = {0, 5, -4}});
  // From an eye in the water beside the shadowed point at (0, -3, -4).
  const Vec3 origin{0, -2, -3};
  const Vec3 way{0, -1, -1};
  expect_rgb(Probe(job)(origin, way), glm::exp(-absorption * (std::sqrt(2.0) + 2.0)));
}

TEST(Opacity, DividesASurfaceAsTheFormulaSays) {
  // L = emission + opacity kd (ambient + I n.l) + ks I (r.v)^s + F Lr + (1-opacity)(1-F) Lt.
  RenderJob job = bare_job();
  job.options.max_depth = 1;
  job.ambient = {0.1, 0.2, 0.3};
  Material m;
  m.kd = {0.5, 0.6, 0.7};
  m.ks = {0.3, 0.2, 0.1};
  m.shininess = 7;
  m.ior = 1.5;
  m.opacity = 0.375;
  m.emission = {0.01, 0.02, 0.03};
  m.reflectivity = {0.9, 0.9, 0.9};  // of no effect: Fresnel's takes its place
  add(job, Box{{-5, -5, -50}, {5, 5, -2}}, {}, m);
  add(job, Sphere{{0, 0, -4}, 0.5}, {}, glowing({1, 2, 3}));  // behind the surface
  add(job, Square{4.0}, Affine::translation({0, 0, 1}) * Affine::rotation(0, 90),
      glowing({3, 2, 1}));  // behind the eye
  job.lights.push_back({.position = {3, 0, 0.5}, .colour = {1, 2, 0.5}, .falloff = {1, 0, 0.1}});
  const Vec3 to_light{3, 0, 2.5};
  const double d = glm::length(to_light);
  const double n_dot_l = 2.5 / d;  // and r.v, as the eye looks along the normal
  const Rgb light = Rgb(1, 2, 0.5) / (1 + 0.1 * d * d);
  const double f = fresnel_by_angles(1, 1, 1.5);
  expect_rgb(Probe(job)({0, 0, 0}, ahead),
             m.emission + m.opacity * m.kd * (job.ambient + light * n_dot_l) +
                 m.ks * light * std::pow(n_dot_l, 7) + f * Rgb(3, 2, 1) +
                 (1 - m.opacity) * (1 - f) * Rgb(1, 2, 3));
}

TEST(Opacity, LetsLightThroughAtEveryCrossing) {
  for (const double opacity : {0.0, 0.25, 0.9, 1.0}) {
    RenderJob job = bare_job();
    Material m = glass(1.5);  // shadow rays pass straight, whatever the index
    m.opacity = opacity;
    add(job, Plane{}, Affine::translation({0, -1, 0}), matt(Rgb(1.0)));
    add(job, Sphere{{0, 2, -1}, 0.5}, {}, m);
    job.lights.push_back({.position = {0, 4, -1}});
    const double share = 1 - opacity;
    expect_rgb(Probe(job)({0, 0, 0}, {0, -1, -1}), Rgb(share * share));
  }
}

TEST(Emission, IsSeenButLightsNothing) {
  RenderJob job = bare_job();
  add(job, Sphere{{0, 0, -4}, 1}, {}, glowing({5, 6, 7}));
  add(job, Plane{}, Affine::translation({0, -2, 0}), matt(Rgb(1.0)));
  Probe probe(job);
  expect_rgb(probe({0, 0, 0}, ahead), {5, 6, 7});
  expect_rgb(probe({0, 0, 0}, {0, -1, -1}), Rgb(0.0));
}

TEST(VisibleLight, IsSeenDirectlyAndInMirrorsAndThroughGlass) {
  for (const bool rectangle : {false, true}) {
    for (const bool visible : {false, true}) {
      RenderJob job = bare_job();
      Light light{.position = {0, 2, -2}, .colour = {3, 2, 1}, .visible = visible};
      if (rectangle) {
        light.rectangle = {{1, 0, 0}, {0, 1, 1}};
      } else {
        light.radius = 0.5;
      }
      job.lights.push_back(light);
      Material mirror = matt(Rgb(0.0));
      mirror.reflectivity = {0.5, 1, 0.25};
      add(job, Plane{}, Affine::translation({0, -2, 0}), mirror);
      add(job, Box{{-9, 0.5, -9}, {9, 1, 9}}, {}, glass(1.0));
      Probe probe(job);
      const Rgb seen = visible ? Rgb(3, 2, 1) : Rgb(0.0);
      expect_rgb(probe({0, 2, 0}, {0, 0, -1}), seen);
      expect_rgb(probe({0, 0, 0}, {0, 1, -1}), seen);                         // through the glass
      expect_rgb(probe({0, 0, 0}, {0, -6, -2}), seen * mirror.reflectivity);  // by the mirror
    }
  }
}

TEST(VisibleLight, CastsNoShadow) {
  // Not its own light's, not another's.
  for (const bool visible : {false, true}) {
    RenderJob job = bare_job();
    add(job, Plane{}, Affine::translation({0, -1, 0}), matt(Rgb(1.0)));
    job.lights.push_back({.position = {0, 3, -1}});
    job.lights.push_back({.position = {0, 1, -1}, .radius = 0.5, .visible = visible});
    // The sphere's half-angle a has sin a = 1/4; it stands overhead: (1 + cos a)/2.
    const double sphere = 0.5 * (1.0 + std::sqrt(15.0) / 4.0);
    const test::Estimate got = Probe(job).estimate({0, 0, 0}, {0, -1, -1}, 16, 64);
    // cos varies within the cone by 1 - cos a = 0.032: even 1024 random samples err by 3e-4.
    EXPECT_NEAR(got.mean.r, 1.0 + sphere, 1e-3) << visible;
  }
}

TEST(Absorption, NothingComesThroughAHalfSpaceWithoutEnd) {
  RenderJob job = before(Rgb(1.0));
  Material sea = tinted();
  sea.absorption = {0.5, 0.0, 0.25};
  add(job, Plane{}, Affine::translation({0, 0, -4}) * Affine::rotation(0, 90), sea);
  expect_rgb(Probe(job)({0, 0, 0}, ahead), Rgb(0, 1, 0));
  expect_rgb(Probe(job)({0, 0, -5}, ahead), Rgb(0, 1, 0));  // and from within
  expect_rgb(Probe(job)({0, 0, 0}, -ahead), Rgb(1.0));
}

}  // namespace
}  // namespace rt
