// The test of boxes by which packets pass over shapes: it loses no crossing that the shape's own
// function would report.
#include <gtest/gtest.h>

#include "stability/spots.h"
#include "stability/wide_rays.h"

namespace rt::stability {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr const char* names[] = {"cone", "blob", "torus", "mesh", "sphere", "box", "cylinder"};

struct MeetTally {
  long hits = 0;
  long passed_over = 0;  ///< lanes that the box test rules out
  long lost = 0;
  std::string first_lost;
};

/// The scalar function's hits, in the lanes and within t_max or just there.
void judge(const Shape& shape, LaneRays& rays, MeetTally& tally) {
  for (const bool at_the_hit : {false, true}) {
    std::array<bool, lane_count> hit{};
    for (std::size_t i = 0; i < lane_count; ++i) {
      const OptionalHit one = std::visit(
          [&](const auto& s) {
            return intersect(s, rays.ray[i], inf, {Leaving::nothing, 0, rays.error[i]});
          },
          shape);
      hit[i] = one.has_value();
      rays.t_max[i] = one && at_the_hit ? one->t : inf;
    }
    const Bounds box = std::visit([](const auto& s) { return bounds(s); }, shape);
    const WideMask may = may_meet(box, rays.wide(), packed(rays.t_max), packed(rays.error));
    for (std::size_t i = 0; i < lane_count; ++i) {
      tally.hits += hit[i];
      tally.passed_over += !may[i];
      if (hit[i] && !may[i] && tally.lost++ == 0) {
        tally.first_lost = described(rays.ray[i]);
      }
    }
  }
}

TEST(MayMeet, LosesNoCrossing) {
  for (const char* name : names) {
    for (const Family& family : families(name)) {
      Random random(37);
      MeetTally tally;
      for (int k = 0; k < 4000; ++k) {
        LaneRays rays;
        const Case first = make_case(family, random);
        for (Ray& ray : rays.ray) {
          ray = make_case(family, random).ray;
        }
        rays.ray[0] = first.ray;
        judge(first.shape, rays, tally);
      }
      EXPECT_EQ(tally.lost, 0) << family.name() << ", " << tally.first_lost;
      EXPECT_GT(tally.hits, 1000) << family.name();
    }
  }
}

TEST(MayMeet, PassesOverWhatIsElsewhere) {
  Random random(41);
  MeetTally tally;
  for (int k = 0; k < 1000; ++k) {
    LaneRays rays;
    for (Ray& ray : rays.ray) {
      ray = {8.0 * random.direction(), random.direction()};
    }
    judge(Blob{}, rays, tally);
  }
  // A ball of radius 1.7 holds the box: from 8 away it fills less than 1.2% of all directions.
  EXPECT_GT(tally.passed_over, 0.98 * 2 * 1000 * lanes);
}

/// A point within some errors of the shape: of an edge, where it has any.
Vec3 nearby(const Shape& shape, double error, Random& random) {
  Vec3 on = spot_on(shape, random).position;
  if (!std::holds_alternative<Torus>(shape) && !std::holds_alternative<Sphere>(shape)) {
    const Ray past = past_an_edge(shape, random);
    on = past.origin + 3.0 * glm::normalize(past.direction);
  }
  return on + random.uniform(0, 4) * error * random.direction();
}

/// Origins that stand for points of the surface, to within their error. A shape may take such a ray
/// for one that has gone in, though the origin is outside and the ray passes the solid by.
TEST(MayMeet, LosesNoRayFromNearTheSurface) {
  for (const char* name : names) {
    Random random(43);
    MeetTally tally;
    for (int k = 0; k < 20000; ++k) {
      const Shape shape = make_case({name, Kind::random, 0}, random).shape;
      LaneRays rays;
      for (std::size_t i = 0; i < lane_count; ++i) {
        rays.error[i] = random.power_of_ten(-4, -2);  // past_an_edge() passes within 1e-3
        rays.ray[i] = {nearby(shape, rays.error[i], random), random.direction()};
      }
      judge(shape, rays, tally);
    }
    EXPECT_EQ(tally.lost, 0) << name << ", " << tally.first_lost;
    EXPECT_GT(tally.hits, 1000) << name;
  }
}

}  // namespace
}  // namespace rt::stability
