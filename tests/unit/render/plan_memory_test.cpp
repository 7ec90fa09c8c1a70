#include <gtest/gtest.h>

#include "pictures.h"
#include "rt/math/rounding.h"
#include "rt/render/accel/box_tree.h"
#include "rt/render/accel/grid.h"
#include "rt/render/plan.h"
#include "rt/render/thin.h"
#include "scenes.h"

namespace rt {
namespace {

constexpr std::size_t count = 20'000;

/// What a plan keeps, in bytes for each of its instances.
double bytes_each(const RenderPlan& plan) {
  const std::size_t all = plan.instances.size() * sizeof(PlannedInstance) +
                          plan.placements.bytes() + plan.shapes.bytes() +
                          plan.coats.size() * sizeof(Coat) +
                          plan.materials.size() * sizeof(PlannedMaterial) +
                          plan.media.size() * sizeof(std::uint32_t) +
                          plan.media_ranges.size() * sizeof(plan.media_ranges[0]) +
                          (plan.tree ? plan.tree->bytes() : 0) +
                          (plan.thin ? plan.thin->kinds.size() : 0);
  return static_cast<double>(all) / static_cast<double>(plan.instances.size());
}

/// Of what make_plan() holds beside the plan while the hierarchy is built: a box of Embree's.
constexpr double bytes_building = 32.0;
constexpr double most_bytes = 200.0;

Vec3 place(std::size_t i) {
  return Vec3(i % 30, i / 30 % 30, i / 900) * 2.5 + 0.3 * std::sin(static_cast<double>(i));
}

/// `make(i)` gives the shape and the map of the i-th instance.
template <class Make>
RenderJob many(Make make) {
  RenderJob job = test::job_looking({-40, 50, -60}, {30, 30, 30}, 32, 24);
  const auto material = std::make_shared<const Material>();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [shape, map] = make(i);
    job.instances.push_back({map, shape, material, nullptr, "thing"});
  }
  return job;
}

void expect_bytes(const RenderJob& job, double snapshot, double plan) {
  const double kept = static_cast<double>(job.instances.bytes()) / count;
  EXPECT_LT(kept, snapshot);
  EXPECT_LT(bytes_each(make_plan(job)), plan);
}

TEST(PlanMemory, OfSpheresPlacedByTheirParameters) {
  const RenderJob job = many([](std::size_t i) {
    return std::pair(std::make_shared<const Shape>(Sphere{place(i), 0.5}), Affine{});
  });
  expect_bytes(job, 50.0, 105.0);
  static_assert(50.0 + 105.0 + bytes_building < most_bytes);
}

TEST(PlanMemory, OfOneSphereScaledAndMoved) {
  const auto ball = std::make_shared<const Shape>(Sphere{});
  const RenderJob job = many([&](std::size_t i) {
    const double size = 0.2 + 1e-5 * static_cast<double>(i);
    return std::pair(ball, Affine::translation(place(i)) * Affine::scaling(Vec3(size)));
  });
  expect_bytes(job, 62.0, 137.0);
}

TEST(PlanMemory, OfAMeshInAFewOrientations) {
  const auto data = std::make_shared<MeshData>();
  data->positions = {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  data->triangles = {{0, 1, 2}};
  const auto mesh = std::make_shared<const Shape>(Mesh{data});
  const RenderJob job = many([&](std::size_t i) {
    const Affine turned = Affine::rotation(1, 20.0 * static_cast<double>(i % 16) + 1.0);
    return std::pair(mesh, Affine::translation(place(i)) * turned);
  });
  // Each map of its own in the snapshot; the plan keeps sixteen linear parts.
  expect_bytes(job, 30.0 + 8 * sizeof(double), 135.0);
}

TEST(PlanMemory, OfAMeshTurnedAnyWayFitsAMillionInTwoGigabytes) {
  const auto data = std::make_shared<MeshData>();
  data->positions = {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  data->triangles = {{0, 1, 2}};
  const auto mesh = std::make_shared<const Shape>(Mesh{data});
  const RenderJob job = many([&](std::size_t i) {
    const auto angle = static_cast<double>(i);
    const Affine turned = Affine::rotation(1, angle) * Affine::rotation(0, 0.7 * angle);
    return std::pair(mesh, Affine::translation(place(i)) * turned);
  });
  expect_bytes(job, 30.0 + 12 * sizeof(double), 185.0);
}

/// Each turned and coloured in its own way.
RenderJob coloured(const Shape& shape) {
  RenderJob job = test::job_looking({-40, 50, -60}, {30, 30, 30}, 32, 24);
  const auto shared = std::make_shared<const Shape>(shape);
  for (std::size_t i = 0; i < count; ++i) {
    const auto angle = static_cast<double>(i);
    const auto material = std::make_shared<Material>();
    material->kd = Rgb(angle / count, 0.5, 0.2);
    job.instances.push_back({Affine::translation(place(i)) * Affine::rotation(1, angle) *
                                 Affine::scaling(Vec3(0.7)),
                             shared, material, nullptr, "thing"});
  }
  return job;
}

TEST(PlanMemory, OfRingsTurnedAndColouredEachInItsWay) {
  EXPECT_LT(bytes_each(make_plan(coloured(Torus{}))), most_bytes);
}

TEST(PlanMemory, OfThinThings) {
  RenderJob job = coloured(Torus{0.5, 0.001});
  job.options.samples = 0;
  const RenderPlan plan = make_plan(job);
  ASSERT_NE(plan.thin, nullptr);
  EXPECT_LT(bytes_each(plan), most_bytes);
}

TEST(PlanMemory, OfBallsWhoseTurnsDoNotShow) {
  const RenderPlan plan = make_plan(coloured(Sphere{}));
  EXPECT_LT(bytes_each(plan), most_bytes - 8 * sizeof(double));
  for (const PlannedInstance& ball : plan.instances) {
    ASSERT_EQ(ball.map, MapKind::scaled);
  }
}

/// How a ball is mapped in a plan of it alone.
MapKind kind_of_ball(const Affine& map, const Sphere& ball = {}, bool chequered = false) {
  RenderJob job = test::job_looking({0, 0, 5}, {0, 0, 0}, 32, 24);
  test::add(job, ball, map, Material{});
  if (chequered) {
    test::paint(job, Checker{Rgb(1.0), Rgb(0.0), 1.0});
  }
  return make_plan(job).instances.at(0).map;
}

TEST(PlanMemory, TurnsOfBallsStayWhereTheyShow) {
  const Affine turn = Affine::rotation(1, 33);
  const Affine map = turn * Affine::scaling(Vec3(0.7));
  EXPECT_EQ(kind_of_ball(map), MapKind::scaled);
  EXPECT_EQ(kind_of_ball(Affine::rotation(1, 90)), MapKind::moved);  // exactly a turn
  EXPECT_EQ(kind_of_ball(map, Sphere{{1, 0, 0}, 1.0}), MapKind::turned);
  EXPECT_EQ(kind_of_ball(turn * Affine::scaling({1, 1, 1 + 1e-14})), MapKind::linear);
  EXPECT_EQ(kind_of_ball(map, {}, true), MapKind::turned);
}

TEST(PlanMemory, ABallWithoutItsTurnIsTheSameBall) {
  PlacementTable table;
  for (const double size : {1.0, -0.3, 3e-9, 1e150}) {
    for (int i = 0; i < 50; ++i) {
      const Affine map = Affine::translation(size * Vec3(3, -1, 2)) * Affine::rotation(1, 7.3 * i) *
                         Affine::rotation(0, 11.9 * i) * Affine::scaling(Vec3(size));
      const auto [kind, index] = table.add(Placement(map, *inverse(map)), true);
      ASSERT_NE(kind, MapKind::turned);
      ASSERT_NE(kind, MapKind::linear);
      table.visit(kind, index, 0.0, [&](const auto& ball) {
        EXPECT_EQ(ball.render_point(Vec3(0.0)), map.offset);
        const Vec3 n = glm::normalize(Vec3(1, -2, i));
        const double reach = 1 + ball.model_per_render() * max_abs(map.offset);
        // The way there and back, and the turn's own roundings, of which there are at most twelve.
        EXPECT_NEAR(glm::length(ball.model_point(map.point(n))), 1.0, gamma(12 + 24) * reach);
      });
    }
  }
}

/// That b is a but for what a map of that kind may err at a place of this size.
void expect_near(const Vec3& a, const Vec3& b, int roundings, double size) {
  EXPECT_LE(max_abs(a - b), gamma(roundings) * size);
}

void expect_near(const Mat3& a, const Mat3& b, int roundings) {
  for (int i = 0; i < 3; ++i) {
    expect_near(a[i], b[i], roundings, norm(b));
  }
}

TEST(PlanMemory, APlacementGivesItsMapsBack) {
  const Affine there = Affine::translation({1, 2, 3});
  const Affine maps[] = {there,
                         there * Affine::scaling(Vec3(-0.3)),
                         there * Affine::rotation(0, 90),
                         there * Affine::rotation(0, 20) * Affine::rotation(1, 33),
                         there * Affine::rotation(2, 70) * Affine::scaling(Vec3(-3e-9)),
                         Affine::rotation(2, 70) * Affine::scaling({1, -1, 1}),
                         Affine::rotation(1, 40) * Affine::scaling({1, 1, 1 + 1e-14}),
                         Affine::rotation(1, 41) * Affine::scaling(Vec3(1e-200)),
                         there * Affine::scaling({0.3, 2, 5}),
                         Affine::rotation(1, 33) * Affine::scaling({1, 2, 3})};
  const MapKind kinds[] = {MapKind::moved,  MapKind::scaled, MapKind::turned, MapKind::turned,
                           MapKind::turned, MapKind::turned, MapKind::linear, MapKind::linear,
                           MapKind::linear, MapKind::linear};
  PlacementTable table;
  for (std::size_t i = 0; i < std::size(maps); ++i) {
    SCOPED_TRACE(i);
    const Placement given(maps[i], *inverse(maps[i]));
    const auto [kind, index] = table.add(given);
    EXPECT_EQ(kind, kinds[i]);
    const Placement got = table.at_open(kind, index);
    EXPECT_EQ(got.render_from_model.linear, given.render_from_model.linear);
    EXPECT_EQ(got.render_from_model.offset, given.render_from_model.offset);
    EXPECT_EQ(got.moved_only, given.moved_only);
    EXPECT_GE(got.model_per_render, given.model_per_render * (1 - gamma(4)));
    EXPECT_GE(got.render_per_model, given.render_per_model * (1 - gamma(4)));
    EXPECT_LE(got.model_per_render, given.model_per_render * 1.7321);
    table.visit(kind, index, 0.0, [&](const auto& map) {
      constexpr int roundings = std::decay_t<decltype(map)>::roundings;
      const Affine& back = given.model_from_render;
      expect_near(got.model_from_render.linear, back.linear, roundings);
      expect_near(got.model_from_render.offset, back.offset, roundings,
                  map.model_per_render() * max_abs(given.render_from_model.offset));
      const Vec3 p(0.1, -3, 7);
      const double reach = map.model_per_render() * max_abs(p) + map.model_offset();
      expect_near(map.model_point(p), back.point(p), roundings, reach);
      const Ray ray = map.model_ray({p, glm::normalize(Vec3(1, 2, -5))});
      EXPECT_EQ(ray.origin, map.model_point(p));
      expect_near(ray.direction, back.vector(glm::normalize(Vec3(1, 2, -5))), roundings,
                  map.model_per_render());
      const Vec3 n = glm::normalize(Vec3(1, -2, 2));
      expect_near(map.render_normal(n), given.render_normal(n), 2 * roundings, 1.0);
      EXPECT_EQ(map.render_point({1, 2, 3}), given.render_from_model.point({1, 2, 3}));
    });
  }
}

TEST(PlanMemory, ATurnThatComesAgainIsKeptOnce) {
  PlacementTable table;
  for (int i = 0; i < 100; ++i) {
    const Affine map = Affine::translation(Vec3(i)) * Affine::rotation(1, 20.0 * (i % 5));
    EXPECT_EQ(table.add(Placement(map, *inverse(map))).kind,
              i % 5 == 0 ? MapKind::moved : i < 5 ? MapKind::turned : MapKind::linear);
  }
}

// Each of them would stand in a good part of all cells.
TEST(PlanMemory, OfAGridOfThingsWithinEachOther) {
  std::vector<Bounds> boxes;
  for (int i = 1; i <= 20'000; ++i) {
    boxes.push_back({Vec3(-1e-3 * i), Vec3(1e-3 * i)});
  }
  EXPECT_LT(static_cast<double>(Grid(boxes).bytes()) / 20'000, 64 * 4 + 32);
}

}  // namespace
}  // namespace rt
