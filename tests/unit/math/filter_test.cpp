#include "rt/math/filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/math/chi_square.h"

namespace rt {
namespace {

using namespace test;
constexpr double alpha = 0.01 / 20;
constexpr Filter all[] = {Filter::box, Filter::tent, Filter::gaussian, Filter::blackman_harris};

Grid square(Filter filter, std::size_t n) {
  const double r = filter_radius(filter);
  return {-r, r, -r, r, n, n};
}

TEST(Filter, SamplesHaveTheDensity) {
  for (Filter f : all) {
    const auto draw = [&](Vec2 u) { return filter_offset(f, u); };
    const auto pdf = [&](double x, double y) { return filter_density(f, {x, y}); };
    EXPECT_GT(density_p(square(f, 24), draw, pdf, 400000, 1, 64), alpha) << static_cast<int>(f);
  }
}

TEST(Filter, DensityIsPositiveSymmetricAndOne) {
  for (Filter f : all) {
    const auto pdf = [&](double x, double y) { return filter_density(f, {x, y}); };
    EXPECT_NEAR(square(f, 1).integrate(pdf, 1000)[0], 1.0, 1e-4) << static_cast<int>(f);
    for (int i = 0; i < 100; ++i) {
      const double x = i / 100.0 * filter_radius(f);
      EXPECT_GE(pdf(x, 0.3), 0.0);
      EXPECT_EQ(pdf(x, 0.3), pdf(-x, -0.3));
    }
  }
}

TEST(Filter, ExtremesStayInside) {
  for (Filter f : all) {
    EXPECT_LT(glm::length(filter_offset(f, {0.5, 0.5})), 1e-12) << static_cast<int>(f);
    for (double u : {0x1p-33, 1e-6, 0.01, 0.5 - 0x1p-33, 0.5 + 0x1p-33, 1 - 0x1p-33}) {
      const Vec2 p = filter_offset(f, {u, 1 - u});
      EXPECT_LE(max_abs(Vec3(p, 0)), filter_radius(f));
      EXPECT_NEAR(p.x, -p.y, 1e-11);
    }
  }
}

TEST(Filter, BlackmanHarrisHasTheStatedWidth) {
  RandomPoints random(3);
  double squares = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = filter_offset(Filter::blackman_harris, random()).x;
    squares += x * x / 100000;
  }
  EXPECT_NEAR(std::sqrt(squares), 0.42, 0.005);
}

}  // namespace
}  // namespace rt
