/// How fast the error of a soft shadow falls with the number of samples, by how the sampler's
/// dimensions are joined. The scene: an edge of a half-plane before a disc-like light (a spherical
/// light's cone through the concentric map), seen from a point that the pixel's two dimensions
/// move:
///     visible where  l.n + w p.n < s,
/// l uniform on the unit disc, p in the unit square about 0, n the edge's direction, s its offset;
/// w is the pixel's width over the penumbra's half-width.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "convergence/fit.h"
#include "rt/math/sampler.h"
#include "rt/math/warp.h"
#include "unit/math/chi_square.h"

namespace rt {
namespace {

using test::Rate;

struct Edge {
  Vec2 n;
  double s;
};

/// The share of the unit disc with l.n < s: a circular segment.
double disc_share(double s) {
  s = std::clamp(s, -1.0, 1.0);
  return 1.0 - (std::acos(s) - s * std::sqrt(1.0 - s * s)) / pi;
}

/// The pixel's mean, by the midpoint rule: the share is smooth, its error is below 1e-4.
double exact(const Edge& e, double w) {
  constexpr int n = 48;
  double sum = 0;
  if (w == 0.0) {
    return disc_share(e.s);
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vec2 p{(i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5};
      sum += disc_share(e.s - w * glm::dot(p, e.n));
    }
  }
  return sum / (n * n);
}

struct Draws {
  Vec2 pixel, light;
};
using Scheme = std::function<Draws(const Sampler&)>;

const Scheme joint = [](const Sampler& s) { return Draws{s.pixel(), s.light()}; };
/// The light's two dimensions from a set of their own.
const Scheme padded = [](const Sampler& s) { return Draws{s.pixel(), s.light({1, 0})}; };
/// Each number from a pixel of its own: independent of all others.
const Scheme independent = [](const Sampler& s) {
  const auto key = static_cast<int>(s.pixel().x * 0x1p31);
  const Sampler a(1, key, static_cast<int>(s.pixel().y * 0x1p31), 0);
  return Draws{a.pixel(), a.light({1, 0})};
};

/// Root mean square error over many edges, each in a pixel of its own.
std::vector<double> errors(const Scheme& scheme, double w, const std::vector<double>& counts) {
  constexpr int edges = 3000;
  std::vector<double> squares(counts.size());
  test::RandomPoints random(3);
  for (int k = 0; k < edges; ++k) {
    const Vec2 u = random();
    const double phi = 2 * pi * u.x;
    const Edge e{{std::cos(phi), std::sin(phi)}, 1.6 * (u.y - 0.5)};
    const double truth = exact(e, w);
    const Sampler pixel(11, k % 64, k / 64, 0);
    double sum = 0;
    std::uint32_t i = 0;
    for (std::size_t c = 0; c < counts.size(); ++c) {
      for (; i < static_cast<std::uint32_t>(counts[c]); ++i) {
        const Draws d = scheme(pixel.at(i));
        sum += glm::dot(to_disc(d.light), e.n) + w * glm::dot(d.pixel - 0.5, e.n) < e.s ? 1.0 : 0.0;
      }
      const double error = sum / counts[c] - truth;
      squares[c] += error * error / edges;
    }
  }
  for (double& s : squares) {
    s = std::sqrt(s);
  }
  return squares;
}

const std::vector<double> powers{4, 8, 16, 32, 64, 128, 256, 512, 1024};

Rate measure(const char* name, const Scheme& scheme, double w) {
  const std::vector<double> e = errors(scheme, w, powers);
  const Rate rate = test::fit_rate(powers, e);
  std::printf("%-12s w %.2f: N^%.3f +- %.3f; RMSE", name, w, rate.slope, rate.standard_error);
  for (double x : e) {
    std::printf(" %.4f", x);
  }
  std::printf("\n");
  return rate;
}

// Among N cells of equal volume in d dimensions, a smooth discontinuity cuts about N^((d-1)/d);
// each holds one point and adds a variance of about 1/N^2, so the error is N^-(1/2 + 1/2d): -3/4
// for the light alone, -5/8 for pixel and light together when the penumbra is no wider than the
// pixel, and in between where it is wider. Each bound below leaves three standard errors of the
// fitted slope.

TEST(Penumbra, LightAloneConvergesFasterThanSevenTenths) {
  const Rate rate = measure("light alone", joint, 0.0);
  EXPECT_LT(rate.slope + 3 * rate.standard_error, -0.7);
}

TEST(Penumbra, RandomSamplingConvergesLikeASquareRoot) {
  for (double w : {0.0, 1.0}) {
    const Rate rate = measure("independent", independent, w);
    EXPECT_NEAR(rate.slope, -0.5, 0.01 + 3 * rate.standard_error);
  }
}

TEST(Penumbra, JointDimensionsKeepTheRateAndPaddedOnesLoseIt) {
  for (double w : {0.5, 1.0, 2.0}) {
    const Rate whole = measure("joint", joint, w);
    const Rate apart = measure("padded", padded, w);
    EXPECT_LT(whole.slope + 3 * whole.standard_error, -0.59);
    EXPECT_LT(whole.slope + 3 * (whole.standard_error + apart.standard_error), apart.slope);
    EXPECT_GT(apart.slope, -0.56);
  }
  const std::vector<double> n{1024};
  EXPECT_LT(errors(joint, 1.0, n)[0], 0.65 * errors(padded, 1.0, n)[0]);
}

// Penumbrae several pixels wide, the common case.
TEST(Penumbra, WidePenumbraeComeNearTheLightsOwnRate) {
  const Rate rate = measure("joint", joint, 0.1);
  EXPECT_LT(rate.slope + 3 * rate.standard_error, -0.65);
}

// No prefix is bad: between powers of two the error stays below that of the power before.
TEST(Penumbra, AnyPrefixIsGood) {
  const std::vector<double> counts{16, 20, 24, 28, 32, 40, 48, 56, 64, 80, 96, 112, 128};
  const std::vector<double> e = errors(joint, 0.25, counts);
  for (std::size_t i = 1; i < e.size(); ++i) {
    EXPECT_LT(e[i], e[(i - 1) / 4 * 4] * 1.02) << counts[i];
  }
}

}  // namespace
}  // namespace rt
