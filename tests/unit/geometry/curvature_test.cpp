// Where surface coordinates wrap or end, and how normals turn along a surface.
#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

SurfacePoint sphere_point(double longitude, double latitude) {
  SurfacePoint p;
  p.normal = Vec3(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                  std::cos(latitude) * std::sin(longitude));
  p.position = p.shading_normal = p.normal;
  return p;
}

/// The two sides of the seam are 2 a apart: u jumps by a turn less that, derivatives by at most
/// their own curvature times it.
template <class S>
void check_seam(const S& shape, const SurfacePoint& p, std::uint32_t feature) {
  const double a = 1e-9;
  SurfacePoint sides[2] = {p, p};
  sides[0].position.z -= a;
  sides[1].position.z += a;
  sides[0].normal.z -= a;
  sides[1].normal.z += a;
  const SurfaceCoordinates before = surface_coordinates(shape, sides[0], feature);
  const SurfaceCoordinates after = surface_coordinates(shape, sides[1], feature);
  EXPECT_GT(before.uv.x, 1 - 1e-6);
  EXPECT_LT(after.uv.x, 1e-6);
  expect_near(before.dp_du, after.dp_du, 100 * a);
  expect_near(before.dp_dv, after.dp_dv, 100 * a);
}

TEST(Coordinates, DerivativesDoNotJumpAtTheSeam) {
  check_seam(Sphere{}, sphere_point(0, 0.4), 0);
  check_seam(Blob{}, sphere_point(0, 0.4), 0);
  SurfacePoint p;
  p.normal = p.shading_normal = Vec3(1, 0, 0);
  p.position = Vec3(1, 0.3, 0);
  check_seam(Cylinder{}, p, 0);
  check_seam(Capsule{1, 1}, p, 0);
  p.position = Vec3(0.6, 0.4, 0);
  check_seam(PointedCone{}, p, 0);
  p.position = Vec3(1.25, 0, 0);
  check_seam(Torus{}, p, 0);
}

TEST(Coordinates, DerivativesHoldNextToThePoles) {
  // A step along a parallel and one along a meridian, by closed form: dp_du is 2 pi times the
  // distance from the axis, dp_dv is pi, whatever the distance.
  for (const double off : {1e-3, 1e-6, 1e-9, 1e-12}) {
    for (const double longitude : {0.1, 1.7, 3.1, 5.0}) {
      const SurfacePoint p = sphere_point(longitude, std::numbers::pi / 2 - off);
      const SurfaceCoordinates c = surface_coordinates(Sphere{}, p, 0);
      const Vec3 along(-std::sin(longitude), 0, std::cos(longitude));
      expect_near(c.dp_du / std::sin(off), 2 * std::numbers::pi * along, 1e-3);
      EXPECT_NEAR(glm::length(c.dp_dv), std::numbers::pi, 1e-12);
      EXPECT_NEAR(glm::dot(c.dp_du, c.dp_dv), 0, 1e-15);
    }
  }
}

/// Against central differences of the normals of neighbouring points; errors as in
/// coordinates_test.cpp, times the curvature.
template <class S>
void check_curvature(const S& shape, const Vec3& origin, const Vec3& direction) {
  const Ray ray{origin, direction};
  const OptionalHit h = intersect(shape, ray, infinity, {});
  ASSERT_TRUE(h.has_value());
  const SurfacePoint p = surface_point(shape, ray, *h);
  const double step = 1e-5;
  const Vec3 any = std::abs(p.normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
  const Vec3 side = glm::normalize(glm::cross(p.normal, any));
  for (const Vec3& tangent : {side, glm::cross(p.normal, side)}) {
    SurfacePoint q[2];
    for (int i = 0; i < 2; ++i) {
      const Ray shifted{origin + (i == 0 ? -step : step) * tangent, direction};
      const OptionalHit g = intersect(shape, shifted, infinity, {});
      ASSERT_TRUE(g && g->feature == h->feature);
      q[i] = surface_point(shape, shifted, *g);
    }
    const Vec3 moved = q[1].position - q[0].position;
    expect_near(normal_change(shape, p, h->feature, moved),
                q[1].shading_normal - q[0].shading_normal, 1e-8);
  }
}

TEST(Curvature, AgreesWithDifferencesOfNormals) {
  const Vec3 from(3.1, 2.2, 4.3);
  check_curvature(Sphere{{0.1, 0.2, 0.3}, 1.5}, from, Vec3(0.2, 0.1, 0.3) - from);
  check_curvature(Torus{}, from, Vec3(0.9, 0.1, 0.3) - from);
  check_curvature(Torus{}, {0.1, 0, 0.2}, {1, 0.1, 0.3});             // the hole's side
  check_curvature(Torus{0.5, 1}, from, Vec3(0.9, 0.1, 0.3) - from);   // the apple
  check_curvature(Torus{0.5, 1}, {0.02, 0.01, 0.03}, {1, 0.2, 0.3});  // the lemon
  check_curvature(Plane{}, from, {-1, -2, -3});
  check_curvature(Square{10}, from, {-1, -2, -3});
  check_curvature(Cylinder{}, {5, 0.6, 0.5}, {-1, 0.01, 0});
  check_curvature(Cylinder{}, {0.5, 3, 0.1}, {-0.01, -1, 0.02});
  check_curvature(Capsule{}, {5, 0.6, 0.1}, {-1, 0.01, 0});
  check_curvature(Capsule{}, {0.1, 3, 0.1}, {-0.01, -1, 0.02});
  check_curvature(PointedCone{}, {5, 0.6, 0.2}, {-1, 0.01, -0.02});
  check_curvature(PointedCone{}, {0.5, -3, 0.1}, {-0.01, 1, 0.02});
  check_curvature(Blob{}, {0.5, 3, 0.1}, {-0.01, -1, 0.02});
  check_curvature(Blob{}, {5, -0.6, 1}, {-1, 0.01, 0});
  check_curvature(Blob{}, {0.5, -3, 0.1}, {-0.01, 1, 0.02});
  check_curvature(Box{{-1, -2, -3}, {1, 2, 3}}, {0.3, 0.4, 7}, {0.01, -0.02, -1});
}

TEST(Curvature, OfAMeshFollowsItsVertexNormals) {
  auto data = std::make_shared<MeshData>();
  data->positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0.5}};
  data->triangles = {{0, 1, 2}};
  data->normals = {glm::normalize(Vec3(-0.3, -0.2, 1)), glm::normalize(Vec3(0.5, 0, 1)),
                   glm::normalize(Vec3(0, 0.4, 1))};
  data->triangle_normals = {{0, 1, 2}};
  check_curvature(Mesh{data}, {0.4, 0.5, 3}, {0.01, 0.02, -1});
  data = std::make_shared<MeshData>(*data);
  for (Vec3& n : data->normals) {
    n = -n;  // inside out: the renderer turns them round, and so must their change
  }
  check_curvature(Mesh{data}, {0.4, 0.5, 3}, {0.01, 0.02, -1});
  data = std::make_shared<MeshData>(*data);
  data->normals.clear();
  data->triangle_normals.clear();
  check_curvature(Mesh{data}, {0.4, 0.5, 3}, {0.01, 0.02, -1});
}

}  // namespace
}  // namespace rt::testing
