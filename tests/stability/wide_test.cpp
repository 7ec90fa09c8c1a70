// Shapes that meet several rays at a time, on the rays that are hard on purpose.
#include <gtest/gtest.h>

#include "stability/spots.h"
#include "stability/wide_rays.h"

namespace rt::stability {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr int packets = 4000;
constexpr const char* names[] = {"sphere", "plane", "square", "box", "cylinder", "torus"};

/// The bound that a search has: mostly none, else about the crossing itself.
double t_max_for(const Case& one, Random& random) {
  const OptionalHit hit =
      std::visit([&](const auto& s) { return intersect(s, one.ray, inf, {}); }, one.shape);
  if (!hit || random.below(2) == 0) {
    return inf;
  }
  const double around[] = {hit->t, std::nextafter(hit->t, 0), std::nextafter(hit->t, inf),
                           2 * hit->t};
  return around[random.below(4)];
}

LaneTally run_family(const Family& family) {
  Random random(17);
  LaneTally tally;
  for (int k = 0; k < packets; ++k) {
    std::array<Case, lane_count> cases;
    LaneRays rays;
    for (std::size_t i = 0; i < lane_count; ++i) {
      cases[i] = make_case(family, random);
      rays.ray[i] = cases[i].ray;
      rays.t_max[i] = t_max_for(cases[i], random);
    }
    for (std::size_t i = 0; i < lane_count; ++i) {  // the shape may differ from case to case
      compare(cases[i].shape, rays, tally, i);
    }
  }
  return tally;
}

/// Fewer decided lanes than this are a fault. Tangent lines are the scalar functions', which decide
/// them in twice the digits, and so are rays along a cylinder's axis, from within a torus, to the
/// second dip of one, or to one without a wide hole.
double least_share(const Family& family) {
  const bool torus = family.shape == "torus";
  switch (family.kind) {
    case Kind::double_root:
      return 0.0;
    case Kind::inside:
      return torus ? 0.0 : 0.99;
    case Kind::spindle:
      return 0.05;
    case Kind::axis:
      return family.shape == "cylinder" ? 0.6 : 0.99;
    default:
      return torus ? 0.85 : 0.99;
  }
}

TEST(WideShapes, GiveTheScalarAnswerOrNone) {
  for (const char* name : names) {
    for (const Family& family : families(name)) {
      const LaneTally tally = run_family(family);
      EXPECT_EQ(tally.wrong, 0) << family.name() << ", " << tally.first_wrong;
      EXPECT_GE(tally.share(), least_share(family)) << family.name();
    }
  }
}

Shape shape_named(const std::string& name, Random& random) {
  return make_case({name, Kind::random, 0}, random).shape;
}

/// A ray from on or near the surface, as those that leave another surface which touches it.
Ray from_nearby(const Shape& shape, double error, Random& random) {
  const Spot spot = spot_on(shape, random);
  const double offsets[] = {0, 0.5, 1, 2, 4};
  const double off = random.sign() * offsets[random.below(5)] * error;
  const Vec3 sideways = glm::cross(spot.normal, random.direction());
  const Vec3 direction =
      random.below(2) == 0
          ? random.direction()
          : glm::normalize(sideways + random.sign() * random.power_of_ten(-12, -1) * spot.normal);
  return {spot.position + off * spot.normal, direction};
}

TEST(WideShapes, LeaveOriginsNearTheSurfaceToTheScalarFunction) {
  for (const char* name : names) {
    Random random(23);
    LaneTally near;
    LaneTally away;
    for (int k = 0; k < packets; ++k) {
      const Shape shape = shape_named(name, random);
      LaneRays rays;
      rays.t_max.fill(inf);
      for (std::size_t i = 0; i < lane_count; ++i) {
        rays.error[i] = random.power_of_ten(-16, -4);
        rays.ray[i] = from_nearby(shape, rays.error[i], random);
      }
      compare(shape, rays, near);
      for (std::size_t i = 0; i < lane_count; ++i) {  // start elsewhere, but with an error
        rays.ray[i] = make_case({name, Kind::random, 0}, random).ray;
      }
      compare(shape, rays, away);
    }
    EXPECT_EQ(near.wrong, 0) << name << ", " << near.first_wrong;
    EXPECT_EQ(away.wrong, 0) << name << ", " << away.first_wrong;
    EXPECT_GE(away.share(), 0.9) << name;
  }
}

TEST(WideShapes, NeverMeetRaysThatAreNone) {
  const Vec3 odd[] = {Vec3(0.0),       {NAN, 1, 0},   {0, inf, 0},       {0, 0, -inf},
                      {NAN, NAN, NAN}, {1e300, 0, 0}, {0, 0x1p-1074, 0}, {0, -0x1p-1060, 1e200}};
  for (const char* name : names) {
    Random random(29);
    LaneTally tally;
    for (int k = 0; k < packets; ++k) {
      const Shape shape = shape_named(name, random);
      LaneRays rays;
      rays.t_max.fill(inf);
      rays.error.fill(random.below(2) == 0 ? 0.0 : 1e-12);
      for (Ray& ray : rays.ray) {
        ray = make_case({name, Kind::random, 0}, random).ray;
        (random.below(2) == 0 ? ray.origin : ray.direction) = odd[random.below(8)];
      }
      compare(shape, rays, tally);
    }
    EXPECT_EQ(tally.wrong, 0) << name << ", " << tally.first_wrong;
  }
}

TEST(WideSphere, IsLeftInwardAsByOneRay) {
  Random random(31);
  for (int k = 0; k < packets; ++k) {
    const Shape shape = shape_named("sphere", random);
    const Sphere& sphere = std::get<Sphere>(shape);
    LaneRays rays;
    for (std::size_t i = 0; i < lane_count; ++i) {
      rays.ray[i] = from_nearby(shape, 1e-16, random);
      rays.t_max[i] = random.below(2) == 0 ? inf : random.uniform(0, 2);
    }
    const WideHit out = leave_inward(sphere, rays.wide(), packed(rays.t_max));
    for (std::size_t i = 0; i < lane_count; ++i) {
      const OptionalHit one =
          intersect(sphere, rays.ray[i], rays.t_max[i], {Leaving::inward, 0, 0});
      ASSERT_EQ(bool{out.hit[i]}, one.has_value()) << described(rays.ray[i]);
      ASSERT_TRUE(!one || out.t[i] == one->t) << described(rays.ray[i]);
      ASSERT_FALSE(out.undecided[i]);
    }
  }
}

/// Any ray that leaves the surface outward; half of them graze it.
TEST(WideTorus, IsLeftForGoodOnlyWhereOneRayNeverReturns) {
  Random random(37);
  int gone = 0;
  int never = 0;
  for (int k = 0; k < 4 * packets; ++k) {
    const Shape shape = shape_named("torus", random);
    const Torus& torus = std::get<Torus>(shape);
    LaneRays rays;
    for (std::size_t i = 0; i < lane_count; ++i) {
      const Spot spot = spot_on(shape, random);
      rays.ray[i] = from_nearby(shape, 0.0, random);
      rays.ray[i].origin = spot.position;
      if (glm::dot(rays.ray[i].direction, spot.normal) < 0.0) {
        rays.ray[i].direction = -rays.ray[i].direction;
      }
      rays.ray[i].direction *= random.power_of_ten(-3, 3);
    }
    const WideMask out = leaves_for_good(torus, rays.wide());
    for (std::size_t i = 0; i < lane_count; ++i) {
      const bool returns =
          intersect(torus, rays.ray[i], inf, {Leaving::outward, 0, 0}).has_value();
      ASSERT_FALSE(returns && out[i]) << described(rays.ray[i]);
      gone += out[i] ? 1 : 0;
      never += returns ? 0 : 1;
    }
  }
  EXPECT_GE(gone, 0.9 * never);
}

}  // namespace
}  // namespace rt::stability
