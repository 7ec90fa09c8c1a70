// Ray differentials against differences of neighbouring rays, and against closed forms.
#include <gtest/gtest.h>

#include "pictures.h"
#include "probe.h"
#include "rt/math/fresnel.h"
#include "rt/render/footprint.h"
#include "rt/render/query.h"

namespace rt {
namespace {

using test::add;
using test::bare_job;
using test::glass;
using test::matt;

Material mirror() {
  Material m = matt(Rgb(0.0));
  m.reflectivity = Rgb(1.0);
  return m;
}

/// A job of 100 x 80 pixels at one sample each; its eye is the origin.
RenderJob job() {
  RenderJob j = bare_job();
  j.options.width = 100;
  j.options.height = 80;
  j.camera.fov = 40;
  return j;
}

/// Follows the ray through picture coordinates (x, y), reflected at opaque things and refracted by
/// glass, until `bounces` are done; returns the last point met.
Vec3 walk(const RenderPlan& plan, const Vec2& xy, int bounces, FootprintTrail& trail) {
  TraceRay ray{Vec3(0.0), plan.camera.direction(xy.x, xy.y)};
  trail.begin(ray);
  ray.direction = glm::normalize(ray.direction);
  for (;; --bounces) {
    const auto hit = closest_hit(plan, ray);
    if (!hit) {
      ADD_FAILURE() << "the ray meets nothing";
      return Vec3(0.0);
    }
    ShadingPoint point = shading_point(plan, ray, *hit);
    trail.arrive(0, ray, hit->t, point);
    if (bounces == 0) {
      return point.position;
    }
    const PlannedMaterial& material = plan.material_of(plan.instances[hit->instance]);
    const bool enters = point.side == Leaving::outward;
    const double n1 = enters ? 1.0 : material.ior;
    const double n2 = enters ? material.ior : 1.0;
    const Vec3 next = material.transmissive
                          ? refract(ray.direction, point.shading_normal, n1, n2).value()
                          : reflect(ray.direction, point.shading_normal);
    trail.branch(point, ray.direction, next, n1 / n2, nullptr);
    ray = leave(point, next);
  }
}

/// Compares with central differences over 1/1000 of a pixel: truncation of about 1e-6 of the
/// differential times the curvature of the map (some tens here at most).
void check(const RenderJob& j, const Vec2& xy, int bounces) {
  const RenderPlan plan = make_plan(j);
  FootprintTrail trail(plan);
  walk(plan, xy, bounces, trail);
  const RayDifferential found = trail.here();
  const double h = 1e-3;
  const Vec2 pixel(1.0 / j.options.width, 1.0 / j.options.height);
  for (int axis = 0; axis < 2; ++axis) {
    Vec2 step(0.0);
    step[axis] = h * pixel[axis];
    FootprintTrail ignored(plan);
    const Vec3 change =
        (walk(plan, xy + step, bounces, ignored) - walk(plan, xy - step, bounces, ignored)) /
        (2.0 * h);
    const Vec3 dp = axis == 0 ? found.dp_dx : found.dp_dy;
    EXPECT_GT(glm::length(change), 0.0);
    EXPECT_LT(glm::length(dp - change), 1e-4 * glm::length(change)) << "axis " << axis;
  }
}

const Vec2 places[] = {{0.5, 0.5}, {0.47, 0.52}, {0.55, 0.46}};

void back_wall(RenderJob& j, double z) {
  add(j, Square{1e4}, Affine::translation({0, 0, z}) * Affine::rotation(0, 90), matt(Rgb(0.5)));
}

TEST(Footprint, OfTheCameraIsThePixelsOwn) {
  RenderJob j = job();
  add(j, Plane{}, Affine::translation({0, -1, 0}) * Affine::rotation(2, 10), matt(Rgb(0.5)));
  check(j, {0.4, 0.8}, 0);
  check(j, {0.7, 0.55}, 0);
  check(j, {0.1, 0.95}, 0);
}

TEST(Footprint, GrowsWithTheWholePathAtAFlatMirror) {
  // Closed form: a mirror 3 ahead and a wall 2 behind the eye are one wall at a distance of 8.
  RenderJob j = job();
  add(j, Square{100}, Affine::translation({0, 0, -3}) * Affine::rotation(0, 90), mirror());
  back_wall(j, 2);
  const RenderPlan plan = make_plan(j);
  FootprintTrail trail(plan);
  walk(plan, {0.5, 0.5}, 1, trail);
  const double pixel = 2.0 * std::tan(20.0 * std::numbers::pi / 180.0) / 80;
  EXPECT_NEAR(glm::length(trail.here().dp_dx), 8 * pixel, 1e-14);
  EXPECT_NEAR(glm::length(trail.here().dp_dy), 8 * pixel, 1e-14);
  for (const Vec2& xy : places) {
    check(j, xy, 1);
  }
}

TEST(Footprint, SpreadsAtASphereMirror) {
  RenderJob j = job();
  add(j, Sphere{{0.05, 0.02, -4}, 1}, Affine::rotation(1, 5), mirror());
  back_wall(j, 6);
  for (const Vec2& xy : places) {
    check(j, xy, 1);
  }
  // On the axis of one straight ahead: angles of incidence are 3/1 of those at the eye, so that the
  // direction turns by (1 + 2 * 3) of the ray's own, from a point 3 away, over a distance of 9.
  RenderJob central = job();
  add(central, Sphere{{0, 0, -4}, 1}, {}, mirror());
  back_wall(central, 6);
  const RenderPlan plan = make_plan(central);
  FootprintTrail trail(plan);
  walk(plan, {0.5, 0.5}, 1, trail);
  const double pixel = 2.0 * std::tan(20.0 * std::numbers::pi / 180.0) / 80;
  EXPECT_NEAR(glm::length(trail.here().dp_dx), (3 + 7 * 9) * pixel, 1e-12);
}

TEST(Footprint, PassesASlabAsSnellsLawSays) {
  // Straight through: inside, the ray turns by 1 / ior of what it does outside.
  RenderJob j = job();
  add(j, Box{{-9, -9, -5}, {9, 9, -3}}, {}, glass(1.6));
  back_wall(j, -10);
  const RenderPlan plan = make_plan(j);
  FootprintTrail trail(plan);
  walk(plan, {0.5, 0.5}, 2, trail);
  const double pixel = 2.0 * std::tan(20.0 * std::numbers::pi / 180.0) / 80;
  EXPECT_NEAR(glm::length(trail.here().dp_dx), (3 + 2 / 1.6 + 5) * pixel, 1e-14);
  for (const Vec2& xy : {Vec2(0.3, 0.2), Vec2(0.8, 0.6)}) {
    check(j, xy, 2);
  }
}

TEST(Footprint, NarrowsAndOpensBehindALens) {
  for (const double z : {-5.5, -8.0, -30.0}) {
    RenderJob j = job();
    add(j, Sphere{{0, 0, -4}, 1}, Affine::rotation(0, 3), glass(1.5));
    back_wall(j, z);
    for (const Vec2& xy : places) {
      check(j, xy, 2);
    }
  }
}

TEST(Footprint, FollowsStretchedMovedAndCurvedMirrors) {
  const Affine stretched = Affine::translation({0.1, 0.1, -5}) * Affine::rotation(0, 20) *
                           Affine::scaling({1.5, 0.8, 1.1});
  for (const Shape& shape : {Shape(Sphere{}), Shape(Torus{1, 0.9}), Shape(Blob{})}) {
    RenderJob j = job();
    add(j, shape, stretched, mirror());
    add(j, Sphere{{0, 0, 0}, 1e3}, {}, matt(Rgb(0.5)));
    check(j, {0.5, 0.52}, 1);
    check(j, {0.45, 0.55}, 1);
  }
}

TEST(Footprint, IsAPixelOverTheRootOfTheSamples) {
  RenderOptions o;
  o.samples = 1;
  EXPECT_EQ(sample_spacing(o), 1.0);
  o.samples = 64;
  EXPECT_EQ(sample_spacing(o), 0.125);
  o.samples = 0;  // adaptive: of its pilots
  o.max_error = 0.6;
  EXPECT_EQ(sample_spacing(o), 0.5);
  o.max_error = 0.0054;  // less where their blur would be a third of the error asked for
  EXPECT_NEAR(sample_spacing(o), 0.1, 1e-15);
  o.max_error = 0.6;
  o.max_samples = 1;
  EXPECT_EQ(sample_spacing(o), 1.0);
  o.aa = AntiAliasing::uniform;
  EXPECT_EQ(sample_spacing(o), 0.25);
}

TEST(Footprint, OfAGlossyBounceIsAtLeastTheLobesShare) {
  const PowerCosineLobe lobe(97.0);  // of variance 1/100 along each axis
  const RayDifferential sharp{{1e-3, 0, 0}, {0, 1e-3, 0}, {1e-6, 0, 0}, {0, 1e-6, 0}};
  const RayDifferential wide = widened(sharp, {0, 0, 1}, lobe, 0.5);
  EXPECT_NEAR(glm::length(wide.dd_dx), 0.5 * std::sqrt(12.0 / 100.0), 1e-9);
  EXPECT_NEAR(glm::length(wide.dd_dy), 0.5 * std::sqrt(12.0 / 100.0), 1e-9);
  EXPECT_GT(glm::dot(wide.dd_dx, wide.dp_dx), 0.0);  // the beam opens
  EXPECT_EQ(wide.dp_dx, sharp.dp_dx);
}

TEST(Footprint, IsNotTrackedWithoutTextures) {
  RenderJob j = job();
  back_wall(j, -3);
  EXPECT_FALSE(make_plan(j).footprints);
  test::paint(j, Checker{});
  EXPECT_TRUE(make_plan(j).footprints);
  j.options.texture_filter = false;
  EXPECT_FALSE(make_plan(j).footprints);
  j.options.texture_filter = true;
  j.options.textures = false;
  EXPECT_FALSE(make_plan(j).footprints);
  const RenderPlan plan = make_plan(j);
  EXPECT_EQ(plan.material_of(plan.instances.back()).textures, nullptr);
}

}  // namespace
}  // namespace rt
