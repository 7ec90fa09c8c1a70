// Which media meet at a surface, and what then becomes of a ray: against chains of Snell's and
// Fresnel's laws written out by hand.
#include <gtest/gtest.h>

#include <numbers>

#include "probe.h"

namespace rt {
namespace {

using test::add;
using test::bare_job;
using test::fresnel_by_angles;
using test::glass;
using test::Probe;
using test::refracted_by_angles;
using test::with_mark;

constexpr double water_index = 1.33;
constexpr double ice_index = 1.31;
constexpr double glass_index = 1.5;

// A handful of interfaces, each with some 30 roundings, none amplified: far below this.
constexpr double chain_rounding = 1e-12;

/// A ray traced by hand: where it is, where it goes, what share of it is left.
struct Chain {
  Vec3 at;
  Vec3 way;  ///< unit
  double weight = 1.0;

  /// On to the plane of coordinate `axis` = `value`.
  void to_plane(int axis, double value) { at += (value - at[axis]) / way[axis] * way; }
  /// On to a sphere, the nearer crossing ahead or the farther.
  void to_sphere(const Vec3& centre, double radius, bool far) {
    const double b = glm::dot(way, centre - at);
    const Vec3 off = centre - at - b * way;
    const double half = std::sqrt(radius * radius - glm::dot(off, off));
    at += (far ? b + half : b - half) * way;
  }
  void refract(Vec3 n, double n1, double n2) {
    n = glm::dot(n, way) < 0.0 ? n : -n;
    weight *= 1.0 - fresnel_by_angles(-glm::dot(n, way), n1, n2);
    way = glm::normalize(refracted_by_angles(way, n, n1, n2));
  }
  void reflect(Vec3 n, double n1, double n2) {
    weight *= fresnel_by_angles(std::abs(glm::dot(n, way)), n1, n2);
    way -= 2.0 * glm::dot(n, way) * n;
  }
};

/// The renderer sends a ray from `start` through the chain's end, with the chain's weight.
void expect_chain(const RenderJob& job, const Vec3& origin, const Vec3& way, Chain end,
                  double onward = 1.0) {
  Probe probe(with_mark(job, end.at + onward * end.way));
  const Rgb got = probe(origin, way);
  EXPECT_NEAR(got.r, end.weight, chain_rounding);
}

const Vec3 slanted = glm::normalize(Vec3(0.3, 0.1, -1));

TEST(Dielectric, ABubbleInGlassInWater) {
  // From outside water: a tank, in it a glass ball, in it a bubble. Depth 6, five pairs of indices.
  RenderJob job = bare_job();
  const Vec3 centre{0.4, 0.2, -6};
  add(job, Box{{-9, -9, -9}, {9, 9, -2}}, {}, glass(water_index));
  add(job, Sphere{centre, 2}, {}, glass(glass_index));
  add(job, Sphere{centre, 1.2}, {}, glass(1.0));
  const Vec3 origin{-1.3, -0.5, 0};
  Chain c{origin, slanted};
  c.to_plane(2, -2);
  c.refract({0, 0, 1}, 1, water_index);
  c.to_sphere(centre, 2, false);
  c.refract(glm::normalize(c.at - centre), water_index, glass_index);
  c.to_sphere(centre, 1.2, false);
  c.refract(glm::normalize(c.at - centre), glass_index, 1);
  c.to_sphere(centre, 1.2, true);
  c.refract(glm::normalize(c.at - centre), 1, glass_index);
  c.to_sphere(centre, 2, true);
  c.refract(glm::normalize(c.at - centre), glass_index, water_index);
  expect_chain(job, origin, slanted, c, 0.5);
  c.to_plane(2, -9);
  c.refract({0, 0, 1}, water_index, 1);
  expect_chain(job, origin, slanted, c);
}

TEST(Dielectric, ABallInWaterReflectsAsGlassAgainstWater) {
  RenderJob job = bare_job();
  add(job, Box{{-9, -9, -9}, {9, 9, 9}}, {}, glass(water_index));
  add(job, Sphere{{0, 0, -5}, 2}, {}, glass(glass_index));
  // The eye is under water.
  const Vec3 way = glm::normalize(Vec3(0.2, 0, -1));
  Chain c{{0, 0, 0}, way};
  c.to_sphere({0, 0, -5}, 2, false);
  c.reflect(glm::normalize(c.at - Vec3(0, 0, -5)), water_index, glass_index);
  expect_chain(job, {0, 0, 0}, way, c);
}

TEST(Dielectric, IceAgainstGlass) {
  // Two boxes that share a face, in either order: one interface, ice to glass.
  for (const bool ice_first : {true, false}) {
    RenderJob job = bare_job();
    const Box ice{{-3, -3, -3}, {3, 3, -1}};
    const Box block{{-3, -3, -5}, {3, 3, -3}};
    add(job, ice_first ? ice : block, {}, glass(ice_first ? ice_index : glass_index));
    add(job, ice_first ? block : ice, {}, glass(ice_first ? glass_index : ice_index));
    Chain c{{0, 0, 0}, slanted};
    c.to_plane(2, -1);
    c.refract({0, 0, 1}, 1, ice_index);
    c.to_plane(2, -3);
    Chain back = c;
    c.refract({0, 0, 1}, ice_index, glass_index);
    expect_chain(job, {0, 0, 0}, slanted, c);
    c.to_plane(2, -5);
    c.refract({0, 0, 1}, glass_index, 1);
    expect_chain(job, {0, 0, 0}, slanted, c);
    back.reflect({0, 0, 1}, ice_index, glass_index);
    back.to_plane(2, -1);
    back.refract({0, 0, 1}, ice_index, 1);
    expect_chain(job, {0, 0, 0}, slanted, back);
  }
}

TEST(Dielectric, TouchingAtPlacesThatRoundingMoves) {
  // The shared face turned and moved: no coordinate is a round number any more.
  for (int k = 0; k < 40; ++k) {
    const Affine place = Affine::translation({0.1 * k, -0.07 * k, -7}) *
                         Affine::rotation(0, 3.7 * k) * Affine::rotation(1, 9.1 * k);
    RenderJob job = bare_job();
    add(job, Box{{-3, -3, -2}, {3, 3, 0.3}}, place, glass(ice_index));
    add(job, Box{{-3, -3, 0.3}, {3, 3, 2}}, place, glass(glass_index));
    // From within the ice through the shared face, in the boxes' own space.
    const Vec3 origin{0.3, -0.2, -1.2};
    const Vec3 way = glm::normalize(Vec3(0.25, -0.1, 1));
    Chain c{origin, way};
    c.to_plane(2, 0.3);
    c.refract({0, 0, 1}, ice_index, glass_index);
    Chain outside = c;
    outside.at = place.point(c.at);
    outside.way = place.vector(c.way);
    Chain start{place.point(origin), place.vector(way)};
    expect_chain(job, start.at, start.way, outside);
  }
}

TEST(Dielectric, OverlappingSolidsHaveTheSmallersMedium) {
  // A ball half in the water: inside the ball the water's surface is no interface.
  RenderJob job = bare_job();
  add(job, Box{{-30, -30, -30}, {30, 0, 30}}, {}, glass(water_index));
  const Vec3 centre{0, 0, -6};
  add(job, Sphere{centre, 2}, {}, glass(glass_index));
  const Vec3 origin{0.2, 2, 0};
  const Vec3 way = glm::normalize(Vec3(0.1, -0.3, -1));
  Chain c{origin, way};
  c.to_sphere(centre, 2, false);
  ASSERT_GT(c.at.y, 0.0);
  c.refract(glm::normalize(c.at - centre), 1, glass_index);
  c.to_sphere(centre, 2, true);
  ASSERT_LT(c.at.y, 0.0);  // it has passed the water's surface inside
  c.refract(glm::normalize(c.at - centre), glass_index, water_index);
  expect_chain(job, origin, way, c);
}

TEST(Dielectric, AHiddenSurfaceDoesNotShow) {
  // The water's surface inside the ball is not there: it neither shines nor tints.
  RenderJob job = bare_job();
  job.ambient = Rgb(1.0);
  Material water = glass(water_index);
  water.kd = Rgb(1.0);
  water.opacity = 0.5;
  water.ks = Rgb(1.0);
  water.emission = Rgb(1.0);
  add(job, Box{{-30, -30, -30}, {30, 0, 30}}, {}, water);
  add(job, Sphere{{0, 0, 0}, 2}, {}, glass(glass_index));
  job.lights.push_back({.position = {0, 1, 0}});
  const Vec3 origin{0, 0.5, 0};
  const Vec3 way = glm::normalize(Vec3(0.3, -1, 0.1));
  Chain c{origin, way};
  c.to_plane(1, -0.8);  // still in the ball
  Probe probe(with_mark(job, c.at));
  EXPECT_NEAR(probe(origin, way).r, 1.0, chain_rounding);
}

TEST(Dielectric, ACameraInsideGlass) {
  RenderJob job = bare_job();
  add(job, Sphere{{0, 0, 0}, 2}, {}, glass(glass_index));
  const Vec3 origin{0.5, 0.3, 0.1};
  Chain c{origin, slanted};
  c.to_sphere({0, 0, 0}, 2, true);
  Chain back = c;
  c.refract(glm::normalize(c.at), glass_index, 1);
  expect_chain(job, origin, slanted, c);
  back.reflect(glm::normalize(back.at), glass_index, 1);
  expect_chain(job, origin, slanted, back, 0.5);
}

TEST(Dielectric, APlaneOfWaterIsTheHalfSpaceBelowIt) {
  // Level, and (the whole scene) turned.
  for (const double turn : {0.0, 25.0, 180.0}) {
    const Affine place = Affine::translation({0, 0.1, -1}) * Affine::rotation(2, turn);
    RenderJob job = bare_job();
    add(job, Plane{}, place, glass(water_index));
    const Vec3 centre{0, -4, -6};
    add(job, Sphere{centre, 2}, place, glass(glass_index));
    const Vec3 origin{0.2, 3, 0};
    const Vec3 way = glm::normalize(centre - origin + Vec3(0.9, 1, 0));
    Chain c{origin, way};
    c.to_plane(1, 0);
    c.refract({0, 1, 0}, 1, water_index);
    c.to_sphere(centre, 2, false);
    c.refract(glm::normalize(c.at - centre), water_index, glass_index);
    c.to_sphere(centre, 2, true);
    c.refract(glm::normalize(c.at - centre), glass_index, water_index);  // on downward
    expect_chain(job, place.point(origin), place.vector(way),
                 {place.point(c.at), place.vector(c.way), c.weight});
  }
}

TEST(Dielectric, EnergyIsSplitExactly) {
  // What a surface of glass reflects and what it lets through make up the whole.
  for (int degrees = 0; degrees < 90; ++degrees) {
    const double a = degrees * std::numbers::pi / 180.0;
    for (const double side : {1.0, -1.0}) {  // from above, from inside
      const Vec3 way{std::sin(a), -side * std::cos(a), 0};
      double shares[2];
      for (const bool above : {true, false}) {
        RenderJob job = bare_job();
        job.options.max_depth = 1;
        add(job, Box{{-1e3, -1e3, -1e3}, {1e3, 0, 1e3}}, {}, glass(glass_index));
        add(job, Square{1e3}, Affine::translation({0, above ? 2.0 : -2.0, 0}),
            test::glowing(Rgb(1.0)));
        shares[above] = Probe(job)(-way, way).r;
      }
      const double n1 = side > 0 ? 1 : glass_index;
      const double n2 = side > 0 ? glass_index : 1;
      const double f = fresnel_by_angles(std::cos(a), n1, n2);
      EXPECT_NEAR(shares[side > 0], f, chain_rounding) << degrees;
      EXPECT_NEAR(shares[0] + shares[1], 1.0, chain_rounding) << degrees;
    }
  }
}

}  // namespace
}  // namespace rt
