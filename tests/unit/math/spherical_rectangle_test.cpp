#include "rt/math/spherical_rectangle.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <deque>

#include "rt/math/warp.h"
#include "unit/math/chi_square.h"

namespace rt {
namespace {

using namespace test;
constexpr double alpha = 0.01 / 20;

/// z times the integral of dx dy / r^3 over [x0,x1] x [y0,y1]: the four corners' atan(x y / z r),
/// in 50 digits.
double exact_solid_angle(double x0, double x1, double y0, double y1, double z) {
  using Real = boost::multiprecision::cpp_bin_float_50;
  const auto corner = [&](double x, double y) {
    const Real xx = x;
    const Real yy = y;
    const Real zz = z;
    return Real(atan(xx * yy / (zz * sqrt(xx * xx + yy * yy + zz * zz))));
  };
  return static_cast<double>(
      Real(corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0)));
}

struct View {
  double x0, y0, z, width, height;
};

SphericalRectangle seen(const View& v) {
  static std::deque<RectangleEdges> kept;
  return {kept.emplace_back(Vec3(v.width, 0, 0), Vec3(0, v.height, 0)), {v.x0, v.y0, v.z}};
}

TEST(SphericalRectangle, SolidAngleIsTheClosedForm) {
  // Offsets and sizes are such that x0 + width is exact: the reference takes it rounded.
  const View views[] = {{-1, -1, 1, 2, 2},
                        {-1, -1, 1e-6, 2, 2},
                        {-1, -1, 1e6, 2, 2},
                        {-0x1p-30, -0x1p-30, 1, 0x1p-29, 0x1p-29},
                        {0.5, 0.25, 1e-8, 2, 3},
                        {-0.5, 0.25, 1e-8, 2, 3},
                        {0.25, -4, 1e-3, 2, 8},
                        {100, 200, 3, 1, 1},
                        {-0x1p-10, -1024, 1, 0x1p-9, 2048},
                        {0x1p26, -1, 1e8, 0x1p-10, 0x1p-10},
                        {0x1p26, 0x1p25, 1e8, 0x1p-10, 0x1p-10},
                        {-1e5, -1e5, 1, 2e5, 3e5},
                        {1, 1, 1e-4, 0x1p-20, 5}};
  for (const View& v : views) {
    const double exact = exact_solid_angle(v.x0, v.x0 + v.width, v.y0, v.y0 + v.height, v.z);
    EXPECT_NEAR(seen(v).solid_angle() / exact, 1.0, 2e-14) << v.x0 << " " << v.z;
  }
  // Six faces of a cube about p.
  EXPECT_NEAR(6 * seen({-1, -1, 1, 2, 2}).solid_angle(), 4 * pi, 1e-14);
  // In the plane, outside: nothing is seen.
  EXPECT_EQ(seen({1, 1, 0, 2, 2}).solid_angle(), 0.0);
}

/// Uniform in solid angle means uniform in the area-weighted plane: density z / r^3 / Omega.
double plane_p(const View& v, int sub) {
  const SphericalRectangle rectangle = seen(v);
  const auto draw = [&](Vec2 u) {
    const Vec3 p = rectangle.sample(u).to_point;
    return Vec2(p.x, p.y);
  };
  const auto pdf = [&](double x, double y) {
    const double r2 = x * x + y * y + v.z * v.z;
    return v.z / (r2 * std::sqrt(r2)) / rectangle.solid_angle();
  };
  const double slack = 1e-9;  // of the rectangle: points on its far edges fall into the last bins
  const Grid grid{v.x0, v.x0 + v.width * (1 + slack), v.y0, v.y0 + v.height * (1 + slack), 8, 8};
  EXPECT_FALSE(rectangle.by_area());
  return density_p(grid, draw, pdf, 100000, 1, sub);
}

TEST(SphericalRectangle, SamplesAreUniformInSolidAngle) {
  EXPECT_GT(plane_p({-1, -1, 1, 2, 2}, 32), alpha);
  EXPECT_GT(plane_p({0.2, 0.3, 0.5, 2, 1}, 64), alpha);
  EXPECT_GT(plane_p({-3, 0.1, 0.3, 2, 4}, 64), alpha);
  EXPECT_GT(plane_p({-1, -2, 0.05, 2, 3}, 256), alpha);
  EXPECT_GT(plane_p({-1e-3, -1e-3, 20, 2e-3, 2e-3}, 16), alpha);
  EXPECT_GT(plane_p({-1e-9, -2e-9, 1, 2e-9, 4e-9}, 16), alpha);
  EXPECT_GT(plane_p({10, 20, 5, 1e-2, 2e-2}, 16), alpha);
  EXPECT_GT(plane_p({10, -20, 1, 1e-2, 40}, 64), alpha);
}

// Whatever the branch, the mean of 1 / pdf is the solid angle.
TEST(SphericalRectangle, AreaFallbackIsUnbiased) {
  const View views[] = {{1e5, 1e5, 1e5, 1e-5, 1e-5}, {3, 3, 1e-9, 2, 1}, {1, 2, 1e-5, 2, 2}};
  for (const View& v : views) {
    const SphericalRectangle rectangle = seen(v);
    EXPECT_TRUE(rectangle.by_area());
    RandomPoints random(7);
    double sum = 0;
    double squares = 0;
    constexpr int n = 100000;
    for (int i = 0; i < n; ++i) {
      const double w = 1.0 / (rectangle.sample(random()).pdf * rectangle.solid_angle());
      sum += w / n;
      squares += w * w / n;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12 + 4 * std::sqrt(std::max(0.0, squares - sum * sum) / n)) << v.z;
  }
}

TEST(SphericalRectangle, ParallelogramsAreSampledByArea) {
  const RectangleEdges edges({2, 0, 0}, {1, 2, 0});
  const SphericalRectangle r(edges, {-1, -1, 2});
  EXPECT_TRUE(r.by_area());
  RandomPoints random(8);
  double sum = 0;
  for (int i = 0; i < 100000; ++i) {
    sum += 1.0 / r.sample(random()).pdf / 100000;
  }
  EXPECT_NEAR(sum / r.solid_angle(), 1.0, 5e-3);
}

TEST(SphericalRectangle, PointsStayOnTheRectangle) {
  RandomPoints random(9);
  for (double z : {1e-3, 0.1, 1.0, 100.0}) {
    const SphericalRectangle r = seen({-0.7, 0.1, z, 2, 3});
    for (int i = 0; i < 5000; ++i) {
      Vec2 u = random();
      u = i == 0 ? Vec2(0x1p-33) : i == 1 ? Vec2(1 - 0x1p-33) : u;
      const Vec3 p = r.sample(u).to_point;
      EXPECT_TRUE(p.x >= -0.7 - 1e-15 && p.x <= 1.3 + 1e-15 && p.y >= 0.1 - 1e-15 &&
                  p.y <= 3.1 + 1e-15);
      EXPECT_EQ(p.z, z);
    }
  }
}

}  // namespace
}  // namespace rt
