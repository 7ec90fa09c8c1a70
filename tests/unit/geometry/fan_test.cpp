// What of a fan of rays a shape stops, against the rays.
#include "rt/geometry/fan.h"

#include <gtest/gtest.h>

#include <random>

namespace rt {
namespace {

class Fans {
 public:
  double in(double lo, double hi) { return std::uniform_real_distribution(lo, hi)(random_); }
  Vec3 point(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  /// From about the shape, towards it.
  Fan towards(const Vec3& target, const Vec3& origin) {
    const Vec3 start = target + point(0.7) - origin;
    return {origin, start, glm::cross(start, point(1.0))};
  }

 private:
  std::mt19937 random_{7};
};

bool hit(const Shape& shape, const Fan& fan, double s) {
  const Ray ray{fan.origin, glm::normalize(fan.start + s * fan.step)};
  return std::visit([&](const auto& x) { return intersect(x, ray, 1e300, {}).has_value(); }, shape);
}

/// Compares with rays where these can decide: not within 1e-9 of an end.
void expect_as_rays(const Shape& shape, const Fan& fan, int& stopped_rays, int& passed_rays) {
  const auto span = stopped(shape, fan);
  if (!span) {
    return;
  }
  for (int i = -20; i <= 20; ++i) {
    const double s = 0.13 * i + 0.001;
    const double clear = 1e-9 * (1.0 + std::abs(s));
    if (std::abs(s - span->lo) < clear || std::abs(s - span->hi) < clear) {
      continue;
    }
    const bool inside = s > span->lo && s < span->hi;
    ASSERT_EQ(hit(shape, fan, s), inside)
        << shape_kind(shape) << ' ' << s << " [" << span->lo << ", " << span->hi << "] from "
        << fan.origin.x << ' ' << fan.origin.y << ' ' << fan.origin.z;
    ++(inside ? stopped_rays : passed_rays);
  }
}

const Shape shapes[] = {Sphere{{0.2, -0.1, 0.3}, 0.6},
                        Box{{-0.5, -0.3, -0.8}, {0.4, 0.9, 0.7}},
                        Cylinder{},
                        PointedCone{},
                        Blob{},
                        Square{1.4}};

TEST(Fan, IsStoppedWhereRaysAre) {
  Fans fans;
  for (const Shape& shape : shapes) {
    int stopped_rays = 0;
    int passed_rays = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 origin = fans.point(4.0);
      expect_as_rays(shape, fans.towards(Vec3(0.0), origin), stopped_rays, passed_rays);
    }
    EXPECT_GT(stopped_rays, 10000) << shape_kind(shape);
    EXPECT_GT(passed_rays, 10000) << shape_kind(shape);
  }
}

// From the very floor that things stand on, some of what they hide lies along it.
TEST(Fan, FromTheFloorThingsStandOn) {
  Fans fans;
  const Shape standing[] = {Cylinder{}, PointedCone{}, Box{{-1, 0, -1}, {1, 1, 1}}};
  for (const Shape& shape : standing) {
    int stopped_rays = 0;
    int passed_rays = 0;
    int known = 0;
    for (int i = 0; i < 2000; ++i) {
      const double angle = fans.in(0.0, 6.28);
      const Vec3 origin = fans.in(1.5, 4.0) * Vec3(std::cos(angle), 0.0, std::sin(angle));
      const double turn = angle + fans.in(-0.5, 0.5);
      const Vec3 up{0.3 * fans.in(-1.0, 1.0), 1.0, 0.3 * fans.in(-1.0, 1.0)};
      const Fan fan{origin, up, {-std::cos(turn), 0.0, -std::sin(turn)}};
      known += stopped(shape, fan).has_value() ? 1 : 0;
      expect_as_rays(shape, fan, stopped_rays, passed_rays);
    }
    EXPECT_EQ(known, 2000) << shape_kind(shape);
    EXPECT_GT(stopped_rays, 1000) << shape_kind(shape);
    EXPECT_GT(passed_rays, 10000) << shape_kind(shape);
  }
}

TEST(Fan, IsNotKnownFromInsideOrTooNear) {
  Fans fans;
  for (const Shape& shape : shapes) {
    if (!std::holds_alternative<Square>(shape)) {
      const Vec3 inside{0.05, 0.1, 0.02};
      EXPECT_FALSE(stopped(shape, fans.towards({5, 1, 0}, inside))) << shape_kind(shape);
    }
  }
  const Fan beside{{0, 1e-12, 0}, {0.3, 1, 0.1}, {1, 0, 0.2}, 1e-11};
  EXPECT_FALSE(stopped(Box{{-1, -1, -1}, {1, 0, 1}}, beside));
  EXPECT_FALSE(stopped(Torus{}, fans.towards(Vec3(0.0), {0, 3, 0})));
}

}  // namespace
}  // namespace rt
