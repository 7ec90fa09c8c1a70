#include <random>

#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

Mesh mesh_of(MeshData data) { return {std::make_shared<const MeshData>(std::move(data))}; }

MeshData triangle() {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  data.triangles = {{0, 1, 2}};
  return data;
}

/// A closed fan of eight triangles around a vertex: an octahedron.
MeshData octahedron() {
  MeshData data;
  data.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  data.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return data;
}

TEST(Mesh, TriangleIsMetFromBothSides) {
  const Mesh mesh = mesh_of(triangle());
  EXPECT_DOUBLE_EQ(t_of(mesh, {0.25, 0.25, 2}, {0, 0, -1}), 2);
  EXPECT_DOUBLE_EQ(t_of(mesh, {0.25, 0.25, -2}, {0, 0, 4}), 0.5);
  EXPECT_EQ(t_of(mesh, {0.6, 0.6, 2}, {0, 0, -1}), -1);
  EXPECT_EQ(t_of(mesh, {0.25, 0.25, 2}, {0, 0, 1}), -1);
  EXPECT_EQ(t_of(mesh, {-1, 0.25, 0}, {1, 0, 0}), -1);  // edge-on
  EXPECT_EQ(t_of(mesh, {0.25, nan, 2}, {0, 0, -1}), -1);
  EXPECT_EQ(t_of(mesh, {0.25, 0.25, 2}, {0, 0, 0}), -1);
}

TEST(Mesh, NormalFollowsTheCorners) {
  const SurfacePoint p = point_of(mesh_of(triangle()), {0.25, 0.25, 2}, {0, 0, -1});
  expect_near(p.normal, {0, 0, 1}, 0);
  expect_near(p.shading_normal, {0, 0, 1}, 0);
}

TEST(Mesh, ShadingNormalIsTheMeanOfTheCorners) {
  MeshData data = triangle();
  data.normals = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  data.triangle_normals = {{0, 1, 2}};
  const SurfacePoint p = point_of(mesh_of(data), {0.25, 0.5, 2}, {0, 0, -1});
  expect_near(p.shading_normal, glm::normalize(Vec3(0.25, 0.5, 0.25)), 1e-15);
  expect_near(p.normal, {0, 0, 1}, 0);
}

TEST(Mesh, CoordinatesAreTheFilesOrTheWeights) {
  MeshData data = triangle();
  const Mesh plain = mesh_of(data);
  const SurfacePoint p = point_of(plain, {0.25, 0.5, 2}, {0, 0, -1});
  EXPECT_DOUBLE_EQ(surface_coordinates(plain, p, 0).uv.x, 0.25);
  EXPECT_DOUBLE_EQ(surface_coordinates(plain, p, 0).uv.y, 0.5);
  data.uvs = {{0, 0}, {0, 2}, {2, 0}};
  data.triangle_uvs = {{0, 1, 2}};
  const SurfaceCoordinates c = surface_coordinates(mesh_of(data), p, 0);
  EXPECT_DOUBLE_EQ(c.uv.x, 1);
  EXPECT_DOUBLE_EQ(c.uv.y, 0.5);
  expect_near(c.dp_du, {0, 0.5, 0}, 1e-15);
  expect_near(c.dp_dv, {0.5, 0, 0}, 1e-15);
}

TEST(Mesh, IsWatertightAlongEdgesAndAtVertices) {
  const Mesh mesh = mesh_of(octahedron());
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const MeshData& data = *mesh.data;
    const Corners& corners = data.triangles[static_cast<std::size_t>(i) % 8];
    const double along = i % 5 == 0 ? 0 : 0.5 + 0.5 * uniform(random);
    const Vec3 target = glm::mix(data.positions[corners[0]], data.positions[corners[1]], along);
    const Vec3 outside(uniform(random), uniform(random), uniform(random));
    // From the inside every ray must find a way to be stopped.
    EXPECT_TRUE(hit(mesh, 0.3 * outside, target - 0.3 * outside).has_value());
  }
}

TEST(Mesh, TriangleThatWasLeftIsNotMetAgain) {
  const Mesh mesh = mesh_of(octahedron());
  const Ray ray{{0.2, 0.3, 3}, {0, 0, -1}};
  const OptionalHit h = intersect(mesh, ray, infinity, {});
  ASSERT_TRUE(h.has_value());
  const SurfacePoint p = surface_point(mesh, ray, *h);
  EXPECT_EQ(t_of(mesh, p.position, {0, 0, 1}, {Leaving::outward, h->feature, 1e-15}), -1);
  EXPECT_NEAR(t_of(mesh, p.position, {0, 0, -1}, {Leaving::inward, h->feature, 1e-15}), 1, 1e-15);
  // On the edge of two triangles the neighbour counts as left too.
  EXPECT_EQ(t_of(mesh, {0.5, 0, 0.5}, {1, 0, 1}, {Leaving::outward, 0, 1e-15}), -1);
}

TEST(Mesh, DegenerateTriangleHasAFiniteNormal) {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  data.triangles = {{0, 1, 2}};
  const SurfacePoint p = surface_point(mesh_of(data), {{1, 1, 5}, {0, 0, -1}}, {4, 0});
  expect_near(p.normal, {0, 0, 1}, 0);
}

}  // namespace
}  // namespace rt::testing
