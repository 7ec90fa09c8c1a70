// Extended lights as points see them.
#include "rt/render/seen_light.h"

#include "unit/math/wide_lanes.h"

namespace rt {
namespace {

using test::Arguments;
using test::same;

PlannedLight rectangle(const Vec3& u, const Vec3& v) {
  return PlannedLight({.position = {0.25, 2, -0.5}, .rectangle = Light::Rectangle{u, v}});
}

const PlannedLight square = rectangle({2, 0, 0}, {0, 0, 2});
const PlannedLight strip = rectangle({1e-3, 0, 0}, {0, 3, 4});
const PlannedLight slanted = rectangle({1, 0, 1}, {1, 0.5, 1});  // by area: nothing is seen of it
const PlannedLight ball({.position = {0.25, 2, -0.5}, .radius = 0.75});
const PlannedLight* const lights[] = {&square, &strip, &slanted, &ball};

/// Anywhere about the lights; in their planes and on their axes among the rest.
Vec3 place(Arguments& random) {
  const std::vector<double> edges{-0.75, 0.25, 1.25, -0.5, 0.5, 2.0, 2.0 + 1e-9, 1e5, 0.0};
  return {random.pick(edges, -3, 3), random.pick(edges, -3, 5), random.pick(edges, -3, 3)};
}

/// What there is to be asked of it.
std::vector<double> answers(const SeenLight& seen, const Vec3& n, const Vec2& u) {
  const Vec3 way = seen.sample(u);
  const Vec2 at = seen.point_of(way);
  const LightLine line = seen.line(at);
  return {seen.depth(),
          seen.mean_cosine(n),
          seen.largest_cosine(n),
          seen.distance(way),
          way.x,
          way.y,
          way.z,
          at.x,
          at.y,
          line.lo,
          line.hi,
          seen.middle().x,
          double(seen.above(n)),
          seen.depth_axis().y};
}

TEST(SeenLight, OfSeveralPointsIsThatOfEach) {
  Arguments random(11);
  int seen_at_all = 0;
  for (int k = 0; k < 20000; ++k) {
    const PlannedLight& light = *lights[random.bits() % std::size(lights)];
    const auto p = test::drawn([&] { return place(random); });
    const WideSeenLight several(test::packed(p), light);
    for (int i = 0; i < lanes; ++i) {
      const auto one = SeenLight::from(p[static_cast<std::size_t>(i)], light);
      const auto lane = several.lane(i);
      ASSERT_EQ(lane.has_value(), one.has_value());
      if (!one) {
        continue;
      }
      ++seen_at_all;
      const Vec3 n = random.direction_or_axis();
      const Vec2 u = random.square();
      const auto expected = answers(*one, n, u);
      const auto given = answers(*lane, n, u);
      for (std::size_t j = 0; j < expected.size(); ++j) {
        ASSERT_TRUE(same(given[j], expected[j])) << j << ": " << given[j] << ' ' << expected[j];
      }
    }
  }
  EXPECT_GT(seen_at_all, 20000);
}

TEST(SeenLight, NoDirectionHasALargerCosine) {
  Arguments random(12);
  double tightest = 1;
  for (int k = 0; k < 20000; ++k) {
    const auto seen = SeenLight::from(place(random), *lights[random.bits() % std::size(lights)]);
    if (!seen) {
      continue;
    }
    const Vec3 n = random.direction();
    const double bound = seen->largest_cosine(n);
    double largest = -1;
    for (int i = 0; i < 16; ++i) {
      largest = std::max(largest, glm::dot(n, seen->sample(random.square())));
    }
    ASSERT_LE(largest, bound + 1e-12);  // points on an edge are off by some roundings
    tightest = std::min(tightest, bound - largest);
  }
  EXPECT_LT(tightest, 1e-3);  // it is a bound of something
}

}  // namespace
}  // namespace rt
