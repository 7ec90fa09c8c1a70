/// Unoccluded irradiance from area lights against closed forms, to 1e-3 of the light's own with
/// 1024 samples. Radiance is 1.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rt/math/sampler.h"
#include "rt/math/spherical_rectangle.h"
#include "rt/math/warp.h"

namespace rt {
namespace {

constexpr std::uint32_t spp = 1024;

/// From a sphere of half-angle alpha whose centre stands at angle theta to the normal. Wholly above
/// the horizon: pi sin^2(alpha) cos(theta). Cut by it: the rest of the projected disc, an ellipse
/// segment and a part of the sphere's outline (Snyder, "Area light sources for real-time graphics",
/// Microsoft Research MSR-TR-96-11; as given by Lagarde and de Rousiers, "Moving Frostbite to PBR",
/// SIGGRAPH 2014).
double sphere_irradiance(double alpha, double theta) {
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  const double sin2 = std::sin(alpha) * std::sin(alpha);
  if (c >= std::sin(alpha)) {
    return pi * sin2 * c;
  }
  if (c <= -std::sin(alpha)) {
    return 0.0;
  }
  const double x = 1.0 / std::tan(alpha);
  const double y = -x * c / s;
  const double z = s * std::sqrt(std::max(0.0, 1.0 - y * y));
  return (c * std::acos(std::clamp(y, -1.0, 1.0)) - x * z) * sin2 + std::atan(z / x);
}

TEST(Irradiance, SphericalLightAtAnyTilt) {
  const Vec3 normal{0, 0, 1};
  int pixel = 0;
  for (double alpha : {1e-4, 0.02, 0.3, 0.8, 1.3, 1.55}) {
    for (int step = 0; step < 31; ++step) {
      const double theta = 0.1 * step;
      const Vec3 centre{std::sin(theta), 0, std::cos(theta)};
      const Sampler first(1, ++pixel, 0, 0);
      double sum = 0;
      double solid_angle = 0;
      for (std::uint32_t i = 0; i < spp; ++i) {
        const auto s = sample_sphere(first.at(i).light(), {0, 0, 0}, centre, std::sin(alpha));
        ASSERT_TRUE(s);
        sum += std::max(0.0, glm::dot(s->direction, normal)) / s->pdf / spp;
        solid_angle = 1.0 / s->pdf;
      }
      EXPECT_NEAR(sum / solid_angle, sphere_irradiance(alpha, theta) / solid_angle, 1e-3)
          << alpha << " " << theta;
    }
  }
}

/// Lambert's formula for a polygon wholly above the horizon: half the sum over edges of the angle
/// it spans times the cosine of its plane's normal to the surface's.
double polygon_irradiance(const std::vector<Vec3>& corners, const Vec3& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = corners[i];
    const Vec3 b = corners[(i + 1) % corners.size()];
    const Vec3 cross = glm::cross(a, b);
    const double length = glm::length(cross);
    sum += 0.5 * std::atan2(length, glm::dot(a, b)) * glm::dot(cross / length, normal);
  }
  return std::abs(sum);
}

TEST(Irradiance, RectangularLight) {
  struct Placement {
    Vec3 corner, u, v;
  };
  const Placement placements[] = {
      {{-1, -1, 2}, {2, 0, 0}, {0, 2, 0}},      {{3, 1, 0.01}, {0, 0, 2}, {0, 4, 0}},
      {{0.5, 0.5, 0.02}, {0, 3, 0}, {3, 0, 0}}, {{-1, -1, 1e-3}, {2, 0, 0}, {0, 2, 0}},
      {{20, 3, 0.1}, {0, 1, 0}, {0, 0, 1e-3}},  {{-1e4, 1, 1e-2}, {2e4, 0, 0}, {0, 0, 0.5}},
      {{1e3, 1e3, 1e3}, {1, 0, 0}, {0, 1, 0}}};
  int pixel = 0;
  for (const Placement& q : placements) {
    const RectangleEdges edges(q.u, q.v);
    const SphericalRectangle light(edges, q.corner);
    const Sampler first(2, ++pixel, 0, 0);
    double sum = 0;
    for (std::uint32_t i = 0; i < spp; ++i) {
      const auto s = light.sample(first.at(i).light());
      sum += glm::normalize(s.to_point).z / s.pdf / spp;
    }
    const double exact = polygon_irradiance(
        {q.corner, q.corner + q.u, q.corner + q.u + q.v, q.corner + q.v}, {0, 0, 1});
    EXPECT_NEAR(sum / light.solid_angle(), exact / light.solid_angle(), 1e-3) << pixel;
  }
}

}  // namespace
}  // namespace rt
