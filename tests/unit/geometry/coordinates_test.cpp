#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

/// Compares analytic derivatives with central differences of neighbouring surface points: for a
/// tangent step q - p, uv changes by the (du, dv) with dp_du du + dp_dv dv = q - p.
template <class S>
void check_derivatives(const S& shape, const Vec3& origin, const Vec3& direction) {
  const Ray ray{origin, direction};
  const OptionalHit h = intersect(shape, ray, infinity, {});
  ASSERT_TRUE(h.has_value());
  const SurfacePoint p = surface_point(shape, ray, *h);
  const SurfaceCoordinates c = surface_coordinates(shape, p, h->feature);
  const double step = 1e-5;  // truncation step^2, rounding 1e-16 / step: both near 1e-10
  const Vec3 any = std::abs(p.normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
  const Vec3 side = glm::normalize(glm::cross(p.normal, any));
  for (const Vec3& tangent : {side, glm::cross(p.normal, side)}) {
    Vec3 points[2];
    Vec2 uvs[2];
    for (int i = 0; i < 2; ++i) {
      const Ray shifted{origin + (i == 0 ? -step : step) * tangent, direction};
      const OptionalHit g = intersect(shape, shifted, infinity, {});
      ASSERT_TRUE(g && g->feature == h->feature);
      const SurfacePoint q = surface_point(shape, shifted, *g);
      points[i] = q.position;
      uvs[i] = surface_coordinates(shape, q, g->feature).uv;
    }
    const Vec2 duv = uvs[1] - uvs[0];
    expect_near(c.dp_du * duv.x + c.dp_dv * duv.y, points[1] - points[0], 1e-9);
  }
}

TEST(Coordinates, DerivativesAgreeWithDifferences) {
  const Vec3 from(3.1, 2.2, 4.3);
  check_derivatives(Sphere{{0.1, 0.2, 0.3}, 1.5}, from, Vec3(0.2, 0.1, 0.3) - from);
  check_derivatives(Torus{}, from, Vec3(0.9, 0.1, 0.3) - from);
  check_derivatives(Torus{0.5, 1}, from, Vec3(0.9, 0.1, 0.3) - from);
  check_derivatives(Torus{0.5, 1}, {0.02, 0.01, 0.03}, {1, 0.2, 0.3});  // on the lemon
  check_derivatives(Plane{}, from, {-1, -2, -3});
  check_derivatives(Square{10}, from, {-1, -2, -3});
  check_derivatives(Cylinder{}, {5, 0.6, 0.5}, {-1, 0.01, 0});
  check_derivatives(Cylinder{}, {0.5, 3, 0.1}, {-0.01, -1, 0.02});
  check_derivatives(Cylinder{}, {0.5, -3, 0.1}, {-0.01, 1, 0.02});
  check_derivatives(PointedCone{}, {5, 0.6, 1}, {-1, 0.01, -0.18});
  check_derivatives(PointedCone{}, {0.5, -3, 0.1}, {-0.01, 1, 0.02});
  check_derivatives(Blob{}, {0.5, 3, 0.1}, {-0.01, -1, 0.02});
  check_derivatives(Blob{}, {5, -0.6, 1}, {-1, 0.01, 0});
  check_derivatives(Blob{}, {0.5, -3, 0.1}, {-0.01, 1, 0.02});
  check_derivatives(Capsule{}, {5, 0.6, 0.1}, {-1, 0.01, 0});
  check_derivatives(Capsule{}, {0.1, 3, 0.1}, {-0.01, -1, 0.02});
  check_derivatives(Capsule{}, {0.1, -3, 0.1}, {-0.01, 1, 0.02});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec3 origin(0.3, 0.4, 0.6);
      Vec3 direction(0.01, -0.02, 0.03);
      origin[axis] = 5 * side;
      direction[axis] = -side;
      check_derivatives(Box{{-1, -2, -3}, {1, 2, 3}}, origin, direction);
    }
  }
}

TEST(Coordinates, BoxFacesAreUnmirroredFromOutside) {
  for (std::uint32_t face = 0; face < 6; ++face) {
    SurfacePoint p;
    p.position = Vec3(0.5);
    Vec3 outward(0.0);
    outward[static_cast<int>(face / 2)] = face % 2 == 1 ? 1 : -1;
    const SurfaceCoordinates c = surface_coordinates(Box{}, p, face);
    expect_near(glm::cross(c.dp_du, c.dp_dv), outward, 0);
  }
}

TEST(Coordinates, LongitudeWrapsIntoTheUnitInterval) {
  for (const double z : {-1e-300, -1e-18, -0.0, 0.0, 1e-18}) {
    SurfacePoint p;
    p.position = p.normal = Vec3(1, 0, z);
    const double u = surface_coordinates(Sphere{}, p, 0).uv.x;
    EXPECT_GE(u, 0);
    EXPECT_LT(u, 1);
  }
}

TEST(Coordinates, AreFiniteAtThePoles) {
  for (const double y : {-1.0, 1.0}) {
    SurfacePoint p;
    p.position = p.normal = Vec3(0, y, 0);
    for (const SurfaceCoordinates& c :
         {surface_coordinates(Sphere{}, p, 0), surface_coordinates(Blob{}, p, y > 0 ? 0 : 2)}) {
      EXPECT_DOUBLE_EQ(c.uv.y, y > 0 ? 1 : 0);
      EXPECT_TRUE(all_finite(c.dp_du));
      EXPECT_TRUE(all_finite(c.dp_dv));
      EXPECT_GT(glm::length(c.dp_dv), 1);
    }
  }
}

TEST(Coordinates, GrowUpward) {
  SurfacePoint p;
  p.position = p.normal = glm::normalize(Vec3(1, 0.5, 0.3));
  EXPECT_GT(surface_coordinates(Sphere{}, p, 0).uv.y, 0.5);
  EXPECT_GT(surface_coordinates(Sphere{}, p, 0).dp_dv.y, 0);
}

}  // namespace
}  // namespace rt::testing
