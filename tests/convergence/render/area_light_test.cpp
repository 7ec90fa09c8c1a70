/// What arrives from area lights, through the whole renderer: irradiance and penumbrae against
/// closed forms, and the limit of the point light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "convergence/fit.h"
#include "rt/math/warp.h"
#include "unit/render/probe.h"

namespace rt {
namespace {

using test::add;
using test::matt;
using test::Probe;

/// A white floor y = 0 looked at from (0,1,0), straight down: the point shaded is the origin.
RenderJob floor_scene(const Light& light, const Material& material = matt(Rgb(1.0))) {
  RenderJob job = test::bare_job();
  add(job, Plane{}, {}, material);
  job.lights.push_back(light);
  return job;
}

test::Estimate at_origin(const RenderJob& job, int pixels, std::uint32_t samples) {
  return Probe(job).estimate({0, 1, 0}, {0, -1, 0}, pixels, samples);
}

// 16 pixels of 256 samples. A mean of max(0, n.l), of which |n.l| <= 1 and which is continuous,
// errs by at most 3e-4 then (measured); random numbers would by 1/sqrt(12 4096) = 5e-3.
constexpr int pixels = 16;
constexpr std::uint32_t samples = 256;

/// The mean of max(0, n.l) over the directions to a sphere of half-angle alpha, whose centre stands
/// at angle theta to the normal. Wholly above: cos(theta) (1 + cos(alpha)) / 2. Cut by the horizon:
/// tests/convergence/irradiance_test.cpp gives the source.
double mean_cosine(double alpha, double theta) {
  const double solid_angle = 4.0 * pi * std::pow(std::sin(alpha / 2), 2);
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  const double sin2 = std::sin(alpha) * std::sin(alpha);
  if (c >= std::sin(alpha)) {
    return c * (1.0 + std::cos(alpha)) / 2.0;
  }
  if (c <= -std::sin(alpha)) {
    return 0.0;
  }
  const double x = 1.0 / std::tan(alpha);
  const double y = -x * c / s;
  const double z = s * std::sqrt(std::max(0.0, 1.0 - y * y));
  return ((c * std::acos(std::clamp(y, -1.0, 1.0)) - x * z) * sin2 + std::atan(z / x)) /
         solid_angle;
}

TEST(SphericalLight, GivesTheClosedFormAtAnyTilt) {
  for (const double alpha : {1e-4, 0.05, 0.4, 1.0, 1.5}) {
    for (double theta = 0.0; theta < 3.1; theta += 0.15) {
      const Vec3 centre = 5.0 * Vec3(std::sin(theta), std::cos(theta), 0);
      const auto got = at_origin(floor_scene({.position = centre, .radius = 5.0 * std::sin(alpha)}),
                                 pixels, samples);
      EXPECT_NEAR(got.mean.r, mean_cosine(alpha, theta), 1e-3) << alpha << " " << theta;
    }
  }
}

TEST(SphericalLight, CastsNoShadowOnWhatIsInsideIt) {
  // All directions alike: the mean of max(0, n.l) is 1/4, whatever stands about.
  for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(1, -2, 1), Vec3(0, 2.9, 0)}) {
    RenderJob job = floor_scene({.position = centre, .radius = 3.0});
    add(job, Sphere{{0.5, 0.5, 0}, 0.4}, {}, matt(Rgb(0.0)));
    EXPECT_NEAR(at_origin(job, pixels, samples).mean.r, 0.25, 1e-3) << centre.y;
  }
}

TEST(RectangularLight, GivesLambertsFormula) {
  struct Placement {
    Vec3 centre, u, v;
  };
  const Placement placements[] = {{{0, 2, 0}, {2, 0, 0}, {0, 0, 2}},
                                  {{3, 2.5, 0}, {0, 4, 0}, {0, 0, 3}},
                                  {{1, 0.3, 2}, {4, 0, 0}, {0, 0.2, 1}},
                                  {{0, 0.01, 0}, {1, 0, 0}, {0, 0, 1}},
                                  {{30, 40, 0}, {1, 0, 0}, {0, 0, 1}}};
  for (const Placement& q : placements) {
    const Vec3 corner = q.centre - 0.5 * (q.u + q.v);
    const Vec3 corners[] = {corner, corner + q.u, corner + q.u + q.v, corner + q.v};
    double irradiance = 0.0;
    for (int i = 0; i < 4; ++i) {
      const Vec3 cross = glm::cross(corners[i], corners[(i + 1) % 4]);
      const double length = glm::length(cross);
      irradiance +=
          0.5 * std::atan2(length, glm::dot(corners[i], corners[(i + 1) % 4])) * cross.y / length;
    }
    // The two triangles' solid angles (Van Oosterom and Strackee).
    double solid_angle = 0.0;
    for (int i = 1; i < 3; ++i) {
      const Vec3 a = glm::normalize(corners[0]);
      const Vec3 b = glm::normalize(corners[i]);
      const Vec3 c = glm::normalize(corners[i + 1]);
      solid_angle += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                                      1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
    }
    const auto got =
        at_origin(floor_scene({.position = q.centre, .rectangle = {{q.u, q.v}}}), pixels, samples);
    EXPECT_NEAR(got.mean.r, std::abs(irradiance / solid_angle), 1e-3) << q.centre.x;
  }
}

TEST(RectangularLight, IsNotShadowedByTheCeilingItLiesIn) {
  // Wherever the eye is, even at the light: the eye is the origin of all arithmetic.
  for (const Vec3& eye : {Vec3(0.1, 1, 0.2), Vec3(0.1, 2, 0.2), Vec3(0.1, 1e3, 0.2)}) {
    RenderJob open = test::bare_job();
    open.camera.eye = eye;
    add(open, Plane{}, {}, matt(Rgb(1.0)));
    open.lights.push_back({.position = {0.1, 2, 0.2}, .rectangle = {{{3, 0, 0.3}, {-0.3, 0, 3}}}});
    RenderJob ceiling = open;
    add(ceiling, Plane{}, Affine::translation({0, 2, 0}), matt(Rgb(1.0)));
    Probe lit(open);
    Probe covered(ceiling);
    const Vec3 origin = Vec3(0.1, 0.9, 0.2) - eye;
    const Vec3 way{0.3, -1, 0.1};
    int shadowed = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
      const Sampler s = Sampler(3, 0, 0, 0).at(i);
      shadowed += covered(origin, way, s) != lit(origin, way, s);
    }
    EXPECT_EQ(shadowed, 0) << eye.y;
  }
}

/// The share of the unit disc with x < s: a circular segment.
double disc_share(double s) {
  s = std::clamp(s, -1.0, 1.0);
  return 1.0 - (std::acos(s) - s * std::sqrt(1.0 - s * s)) / pi;
}

/// A distant sphere overhead, of half-angle alpha, and a half-plane whose edge is seen at x of its
/// half-width. The distance makes the cone's directions a disc: cos and the cone's curvature differ
/// from 1 by alpha^2 / 2 = 5e-5.
constexpr double alpha = 0.01;
RenderJob half_plane(double x) {
  RenderJob job = floor_scene({.position = {0, 1000, 0}, .radius = 1000 * std::sin(alpha)});
  add(job, Square{200.0}, Affine::translation({-100 - 10 * std::tan(alpha) * x, 10, 0}),
      matt(Rgb(0.0)));
  return job;
}

/// Straight at the origin, below the half-plane.
const Vec3 from_below{-0.5, 1, 0};

TEST(Penumbra, OfAHalfPlaneIsACircularSegment) {
  for (double x = -1.2; x < 1.25; x += 0.1) {
    const auto got = Probe(half_plane(x)).estimate(from_below, -from_below, pixels, samples);
    EXPECT_NEAR(got.mean.r, disc_share(x), 1e-3 + 4.0 * got.standard_error.r) << x;
    EXPECT_LT(got.standard_error.r, 2e-3) << x;
  }
}

/// The area that two discs of radii 1 and r share, their centres d apart.
double overlap(double r, double d) {
  if (d >= 1 + r) {
    return 0.0;
  }
  if (d <= std::abs(1 - r)) {
    return pi * std::min(1.0, r * r);
  }
  const double a = std::acos((d * d + 1 - r * r) / (2 * d));
  const double b = std::acos((d * d + r * r - 1) / (2 * d * r));
  return a + r * r * b - d * std::sin(a);
}

TEST(Penumbra, OfASphereIsALune) {
  for (const double r : {0.5, 1.0, 2.0}) {
    for (double d = 0.0; d < 3.2; d += 0.2) {
      RenderJob job = floor_scene({.position = {0, 1000, 0}, .radius = 1000 * std::sin(alpha)});
      const Vec3 centre{10 * alpha * d, 10, 0};
      add(job, Sphere{centre, 10 * std::sin(alpha * r)}, {}, matt(Rgb(0.0)));
      const auto got = Probe(job).estimate({0, 1, 0}, {0, -1, 0}, pixels, samples);
      // The tangents of angles up to 0.04 differ from them by 2e-5.
      EXPECT_NEAR(got.mean.r, 1.0 - overlap(r, d) / pi, 1e-3 + 4.0 * got.standard_error.r)
          << r << " " << d;
    }
  }
}

TEST(Penumbra, ErrorFallsFasterThanSevenTenths) {
  const std::vector<double> counts{4, 8, 16, 32, 64, 128, 256};
  std::vector<double> errors;
  for (const double n : counts) {
    double squares = 0.0;
    int edges = 0;
    for (double x = -0.79; x < 0.8; x += 0.02) {
      Probe probe(half_plane(x));
      for (int pixel = 0; pixel < 6; ++pixel, ++edges) {
        const Sampler first(5, edges, pixel, 0);
        double mean = 0.0;
        for (std::uint32_t i = 0; i < n; ++i) {
          mean += probe(from_below, -from_below, first.at(i)).r / n;
        }
        squares += (mean - disc_share(x)) * (mean - disc_share(x));
      }
    }
    errors.push_back(std::sqrt(squares / edges));
  }
  const test::Rate rate = test::fit_rate(counts, errors);
  std::printf("soft shadow: N^%.3f +- %.3f; RMSE", rate.slope, rate.standard_error);
  for (const double e : errors) {
    std::printf(" %.4f", e);
  }
  std::printf("\n");
  // -3/4 is expected (penumbra_test.cpp); three standard errors of the fit remain.
  EXPECT_LT(rate.slope + 3.0 * rate.standard_error, -0.7);
}

/// Polished, seen at 45 degrees: diffuse and highlight.
RenderJob polished_floor(const Light& light) {
  Material m = matt(Rgb(0.5));
  m.ks = Rgb(0.5);
  m.shininess = 60;
  return floor_scene(light, m);
}
const Vec3 eye{-1, 1, 0};

TEST(SmallLights, ConvergeToThePointLight) {
  for (const Vec3& place : {Vec3(4, 4, 0), Vec3(4, 3.5, 0.4), Vec3(0, 5, 1)}) {
    const Light point{.position = place, .falloff = {0, 0, 0.05}};
    const double limit = Probe(polished_floor(point))(eye, -eye).r;
    for (const double size : {1e-1, 1e-2, 1e-4, 1e-8}) {
      Light sphere = point;
      sphere.radius = size;
      Light rectangle = point;
      rectangle.rectangle = {{size, 0, 0}, {0, 0, size}};
      for (const Light& light : {sphere, rectangle}) {
        const auto got = Probe(polished_floor(light)).estimate(eye, -eye, 8, 64);
        // Within the light's extent, s = size / 5 in angle, cos^60 changes by at most 60 s
        // relatively; that of a sphere also has its surface nearer, falloff 2 s.
        const double s = size / glm::length(place);
        EXPECT_NEAR(got.mean.r, limit, 62.0 * s * limit + 1e-12) << place.y << " " << size;
      }
    }
  }
}

TEST(GrowingALight, NeverBrightensMattThings) {
  // The falloff is left out: a growing sphere comes nearer.
  for (const double height : {5.0, 2.0, 0.5}) {
    double before = Probe(floor_scene({.position = {4, height, 0}}))({0, 1, 0}, {0, -1, 0}).r;
    for (const double radius : {0.1, 0.5, 1.0, 2.0, 4.0}) {
      if (radius * radius > 16 + height * height) {
        break;
      }
      const auto got =
          at_origin(floor_scene({.position = {4, height, 0}, .radius = radius}), pixels, samples);
      const double closed =
          mean_cosine(std::asin(radius / std::hypot(4.0, height)), std::atan2(4.0, height));
      EXPECT_NEAR(got.mean.r, closed, 1e-3);
      // Above the horizon. Below it, more of the light rises as it grows.
      if (radius < height) {
        EXPECT_LT(got.mean.r, before + 1e-3) << radius;
      }
      before = got.mean.r;
    }
  }
}

}  // namespace
}  // namespace rt
