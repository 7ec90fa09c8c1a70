#include <gtest/gtest.h>

#include "rt/render/accel/box_tree.h"
#include "rt/render/accel/grid.h"
#include "rt/render/plan.h"
#include "scenes.h"

namespace rt {
namespace {

constexpr std::size_t count = 20'000;

/// What a plan keeps, in bytes for each of its instances, materials apart.
double bytes_each(const RenderPlan& plan) {
  const std::size_t all = plan.instances.size() * sizeof(PlannedInstance) +
                          plan.placements.bytes() + plan.shapes.bytes() +
                          (plan.bounded.size() + plan.media.size()) * sizeof(std::uint32_t) +
                          plan.media_ranges.size() * sizeof(plan.media_ranges[0]) +
                          (plan.tree ? plan.tree->bytes() : 0);
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
  expect_bytes(job, 30.0 + 12 * sizeof(double), 300.0);
}

TEST(PlanMemory, APlacementGivesItsMapsBack) {
  const Affine maps[] = {Affine::translation({1, 2, 3}),
                         Affine::translation({1, 2, 3}) * Affine::scaling(Vec3(-0.3)),
                         Affine::translation({1, 2, 3}) * Affine::scaling({0.3, 2, 5}),
                         Affine::rotation(1, 33) * Affine::scaling({1, 2, 3})};
  const MapKind kinds[] = {MapKind::moved, MapKind::scaled, MapKind::linear, MapKind::linear};
  PlacementTable table;
  for (std::size_t i = 0; i < std::size(maps); ++i) {
    const Placement given(maps[i], *inverse(maps[i]));
    const auto [kind, index] = table.add(given);
    EXPECT_EQ(kind, kinds[i]);
    const Placement got = table.at_open(kind, index);
    EXPECT_EQ(got.render_from_model.linear, given.render_from_model.linear);
    EXPECT_EQ(got.render_from_model.offset, given.render_from_model.offset);
    EXPECT_EQ(got.model_from_render.linear, given.model_from_render.linear);
    EXPECT_EQ(got.model_from_render.offset, given.model_from_render.offset);
    EXPECT_EQ(got.moved_only, given.moved_only);
    EXPECT_EQ(got.model_per_render, given.model_per_render);
    EXPECT_EQ(got.render_per_model, given.render_per_model);
    const Ray ray{{0.1, -3, 7}, glm::normalize(Vec3(1, 2, -5))};
    table.visit(kind, index, 0.0, [&](const auto& map) {
      EXPECT_EQ(map.model_ray(ray).origin, given.ray(ray).origin);
      EXPECT_EQ(map.model_ray(ray).direction, given.ray(ray).direction);
      const Vec3 n = glm::normalize(Vec3(1, -2, 2));
      EXPECT_EQ(map.render_normal(n), given.render_normal(n));
      EXPECT_EQ(map.render_point({1, 2, 3}), given.render_from_model.point({1, 2, 3}));
    });
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
