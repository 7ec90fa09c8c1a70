#pragma once
/// Statistical tests of a sampler against the density it claims. Draws are independent (a fixed
/// seed): well spread points would fit better than chance and defeat the test.
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "rt/math/vec.h"

namespace rt::test {

/// Chance that k independent squared normal deviates sum to `sum` or more.
inline double chi_square_tail(double sum, std::size_t k) {
  return boost::math::gamma_q(0.5 * static_cast<double>(k), 0.5 * sum);
}

/// The p-value of Pearson's test. Bins expecting fewer than 5 are merged into one; a count where
/// nothing is expected gives 0.
inline double chi_square_p(const std::vector<double>& observed,
                           const std::vector<double>& probability, double draws) {
  double sum = 0.0;
  double rare_seen = 0.0;
  double rare_expected = 0.0;
  std::size_t bins = 0;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    const double expected = probability[i] * draws;
    if (expected < 5.0) {
      if (expected == 0.0 && observed[i] > 0.0) {
        return 0.0;
      }
      rare_seen += observed[i];
      rare_expected += expected;
      continue;
    }
    sum += (observed[i] - expected) * (observed[i] - expected) / expected;
    ++bins;
  }
  if (rare_expected >= 5.0) {
    sum += (rare_seen - rare_expected) * (rare_seen - rare_expected) / rare_expected;
    ++bins;
  }
  return bins > 1 ? chi_square_tail(sum, bins - 1) : 1.0;
}

/// A grid over a rectangle [x0,x1) x [y0,y1) of any two parameters.
struct Grid {
  double x0, x1, y0, y1;
  std::size_t nx, ny;

  std::size_t bins() const { return nx * ny; }
  /// bins() for a point outside.
  std::size_t bin(double x, double y) const {
    const double i = std::floor((x - x0) / (x1 - x0) * static_cast<double>(nx));
    const double j = std::floor((y - y0) / (y1 - y0) * static_cast<double>(ny));
    if (!(i >= 0 && j >= 0 && i < static_cast<double>(nx) && j < static_cast<double>(ny))) {
      return bins();
    }
    return static_cast<std::size_t>(i) * ny + static_cast<std::size_t>(j);
  }
  /// The integral of f(x, y) over each bin, by the midpoint rule with sub x sub cells a bin.
  template <typename F>
  std::vector<double> integrate(const F& f, int sub) const {
    std::vector<double> result(bins());
    const double hx = (x1 - x0) / static_cast<double>(nx) / sub;
    const double hy = (y1 - y0) / static_cast<double>(ny) / sub;
    for (std::size_t i = 0; i < nx * static_cast<std::size_t>(sub); ++i) {
      for (std::size_t j = 0; j < ny * static_cast<std::size_t>(sub); ++j) {
        const double x = x0 + (static_cast<double>(i) + 0.5) * hx;
        const double y = y0 + (static_cast<double>(j) + 0.5) * hy;
        result[i / static_cast<std::size_t>(sub) * ny + j / static_cast<std::size_t>(sub)] +=
            f(x, y) * hx * hy;
      }
    }
    return result;
  }
};

/// Independent points of the unit square.
class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : generator_(seed) {}
  Vec2 operator()() {
    const double x = one();
    return {x, one()};
  }

 private:
  double one() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 generator_;
};

/// The p-value of samples (x, y) = draw(u) against the density f(x, y).
template <typename Draw, typename F>
double density_p(const Grid& grid, const Draw& draw, const F& f, int draws, unsigned seed = 1,
                 int sub = 16) {
  RandomPoints random(seed);
  std::vector<double> count(grid.bins() + 1);
  for (int i = 0; i < draws; ++i) {
    const Vec2 p = draw(random());
    ++count[grid.bin(p.x, p.y)];
  }
  std::vector<double> probability = grid.integrate(f, sub);
  probability.push_back(0.0);
  return chi_square_p(count, probability, draws);
}

/// A direction as (z, azimuth), in which solid angle is area; and back.
inline Vec2 cylinder_of(const Vec3& w) { return {w.z, std::atan2(w.y, w.x)}; }
inline Vec3 on_sphere(double z, double azimuth) {
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}
inline Grid sphere_grid(std::size_t nz, std::size_t nphi) {
  return {
      -1.0, std::nextafter(1.0, 2.0), -std::numbers::pi, std::nextafter(std::numbers::pi, 4.0), nz,
      nphi};
}

}  // namespace rt::test
