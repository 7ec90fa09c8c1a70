#include "stability/leaving.h"

#include <gtest/gtest.h>

#include <map>

#include "stability/closed_meshes.h"

namespace rt::stability {
namespace {

LeavingTally total(Policy policy, long count) {
  LeavingTally sum;
  std::uint64_t seed = 1;
  for (const Placement& placement : placements()) {
    sum.add(run_leaving(placement, policy, count, seed++));
  }
  return sum;
}

TEST(LeavingASurface, BySideNeitherShadowsItselfNorLeaks) {
  const LeavingTally tally = total(Policy::side, 400);
  EXPECT_EQ(tally.false_hits, 0);
  EXPECT_EQ(tally.leaks, 0);
  EXPECT_EQ(tally.wrong, 0);
}

TEST(LeavingASurface, AnEqualShapeInTheSamePlaceCountsAsLeft) {
  const LeavingTally tally = total(Policy::touching, 400);
  EXPECT_EQ(tally.false_hits, 0);
  EXPECT_EQ(tally.leaks, 0);
  EXPECT_EQ(tally.wrong, 0);
}

TEST(ClosedMeshes, AreClosedAndFaceOutward) {
  for (const Mesh& mesh : {box_mesh(), sphere_mesh(2), torus_mesh(12, 6)}) {
    std::map<std::array<double, 6>, int> edges;  // by their ends, each way
    double volume = 0;
    for (const Corners& corners : mesh.data->triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& a = mesh.data->positions[corners[i]];
        const Vec3& b = mesh.data->positions[corners[(i + 1) % 3]];
        ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
        --edges[{b.x, b.y, b.z, a.x, a.y, a.z}];
      }
      const Vec3& a = mesh.data->positions[corners[0]];
      volume += glm::dot(a, glm::cross(mesh.data->positions[corners[1]],
                                       mesh.data->positions[corners[2]])) /
                6;
    }
    EXPECT_GT(volume, 1);
    for (const auto& [ends, count] : edges) {
      ASSERT_EQ(count, 0);
    }
  }
}

TEST(Suite, RejectsAFixedEpsilon) { EXPECT_GT(total(Policy::epsilon, 100).failures(), 100); }

}  // namespace
}  // namespace rt::stability
