#include "rt/math/lobe.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/beta.hpp>
#include <cmath>

#include "rt/math/warp.h"
#include "unit/math/chi_square.h"

namespace rt {
namespace {

using namespace test;
constexpr double alpha = 0.01 / 20;
const Vec3 normal{0, 0, 1};

Vec3 mirror_at(double cos_theta) { return {std::sqrt(1.0 - cos_theta * cos_theta), 0, cos_theta}; }

TEST(PowerCosineLobe, MassAboveIsTheIncompleteBeta) {
  for (double e : {0.0, 0.5, 1.0, 2.0, 7.3, 50.0, 1e3, 1e6, 2e10}) {
    const PowerCosineLobe lobe(e);
    for (double c : {0.0, 1e-9, 1e-5, 1e-3, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999, 1.0}) {
      const double between = c == 1.0 ? 1.0 : boost::math::ibeta(0.5, 0.5 * (e + 1), c * c);
      EXPECT_NEAR(lobe.mass_above(c), 0.5 + 0.5 * between, 2e-13) << e << " " << c;
    }
  }
}

TEST(PowerCosineLobe, DensityIntegratesToOne) {
  for (double e : {0.0, 1.0, 20.0, 300.0}) {
    for (double c : {0.0, 0.05, 0.4, 1.0}) {
      const PowerCosineLobe lobe(e);
      const Vec3 m = mirror_at(c);
      const Grid grid{0, 1, -pi, pi, 1, 1};
      const auto f = [&](double z, double phi) { return lobe.pdf(on_sphere(z, phi), m, normal); };
      EXPECT_NEAR(grid.integrate(f, 1000)[0], 1.0, 5e-3) << e << " " << c;
    }
  }
}

/// Sum over bins of the squared deviation of the weighted histogram from the density's integral, in
/// units of its variance. Weights vary, so counts alone are not Poisson.
double weighted_p(const PowerCosineLobe& lobe, const Vec3& m, unsigned seed) {
  constexpr int draws = 200000;
  const Grid grid = sphere_grid(16, 16);
  std::vector<double> sum(grid.bins() + 1);
  std::vector<double> squares(grid.bins() + 1);
  RandomPoints random(seed);
  for (int i = 0; i < draws; ++i) {
    const auto s = lobe.sample(random(), m, normal);
    const Vec2 c = cylinder_of(s.direction);
    sum[grid.bin(c.x, c.y)] += s.weight;
    squares[grid.bin(c.x, c.y)] += s.weight * s.weight;
  }
  const auto expected = grid.integrate(
      [&](double z, double phi) { return lobe.pdf(on_sphere(z, phi), m, normal); }, 48);
  double total = 0;
  std::size_t bins = 0;
  for (std::size_t i = 0; i < grid.bins(); ++i) {
    const double mean = expected[i] * draws;
    if (mean >= 50) {  // enough for a normal deviate with an estimated variance
      total += (sum[i] - mean) * (sum[i] - mean) / (squares[i] - sum[i] * sum[i] / draws);
      ++bins;
    }
  }
  return chi_square_tail(total, bins);
}

TEST(PowerCosineLobe, SamplesHaveTheDensity) {
  unsigned seed = 1;
  for (double e : {0.0, 1.0, 8.0, 60.0}) {
    for (double c : {0.0, 0.1, 0.5, 1.0}) {
      EXPECT_GT(weighted_p(PowerCosineLobe(e), mirror_at(c), ++seed), alpha) << e << " " << c;
    }
  }
}

TEST(PowerCosineLobe, WeightsAverageToOneAndNeverExceedTwo) {
  for (double e : {0.0, 3.0, 100.0, 1e6, 1e12}) {
    for (double c : {0.0, 1e-9, 1e-4, 0.02, 0.3, 1.0}) {
      const PowerCosineLobe lobe(e);
      const Vec3 m = mirror_at(c);
      RandomPoints random(11);
      constexpr int n = 20000;
      double sum = 0;
      double squares = 0;
      for (int i = 0; i < n; ++i) {
        const auto s = lobe.sample(random(), m, normal);
        EXPECT_LE(s.weight, 2.0 + 1e-12);
        EXPECT_GE(s.direction.z, 0.0);
        EXPECT_NEAR(glm::length(s.direction), 1.0, 2e-15);
        sum += s.weight / n;
        squares += s.weight * s.weight / n;
      }
      const double error = std::sqrt(std::max(0.0, squares - sum * sum) / n);
      EXPECT_NEAR(sum, 1.0, 4 * error + 1e-9) << e << " " << c;
    }
  }
}

// As glossiness goes to 0 the lobe becomes the mirror: its spread is about 1/sqrt(exponent).
TEST(PowerCosineLobe, TendsToTheMirror) {
  RandomPoints random(12);
  for (double c : {0.0, 1e-7, 0.5, 1.0}) {
    const PowerCosineLobe lobe(2e16);
    for (int i = 0; i < 100; ++i) {
      EXPECT_LT(max_abs(lobe.sample(random(), mirror_at(c), normal).direction - mirror_at(c)),
                1e-7);
    }
  }
}

}  // namespace
}  // namespace rt
