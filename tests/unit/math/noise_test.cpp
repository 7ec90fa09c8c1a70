#include "rt/math/noise.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "rt/math/octaves.h"
#include "unit/math/chi_square.h"

namespace rt {
namespace {

using test::RandomPoints;

// The definition of the paper, evaluated another way: each corner's gradient is recovered from the
// derivative of the noise on the lattice, where it is the gradient, and the eight ramps are blended
// by products of weights, in 50 digits.
double blended(const Noise& noise, const Vec3& p) {
  using Real = boost::multiprecision::cpp_bin_float_50;
  const Vec3 cell = glm::floor(p);
  Real sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 offset{corner & 1, (corner >> 1) & 1, corner >> 2};
    const Vec3 gradient = noise.sample(cell + offset).gradient;
    Real term = 0;
    for (int k = 0; k < 3; ++k) {
      term += Real(gradient[k]) * (Real(p[k]) - cell[k] - offset[k]);
    }
    for (int k = 0; k < 3; ++k) {
      const Real t = Real(p[k]) - cell[k];
      const Real rising = 10 * t * t * t - 15 * t * t * t * t + 6 * t * t * t * t * t;
      term *= offset[k] != 0 ? rising : 1 - rising;
    }
    sum += term;
  }
  return static_cast<double>(sum);
}

Vec3 random_point(RandomPoints& random, double scale) {
  const Vec2 a = random();
  return scale * (2.0 * Vec3(a.x, a.y, random().x) - 1.0);
}

TEST(Noise, MatchesThePublishedValue) {
  EXPECT_EQ(Noise().value({3.14, 42, 7}), 0.13691995878400012);
  EXPECT_EQ(Noise().sample({3.14, 42, 7}).value, 0.13691995878400012);
}

TEST(Noise, MatchesAnIndependentComputation) {
  RandomPoints random(1);
  for (std::uint64_t seed : {0u, 1u, 77u}) {
    const Noise noise(seed);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = random_point(random, 300.0);
      EXPECT_NEAR(noise.value(p), blended(noise, p), 1e-14);
    }
  }
}

// Computed with exact fractions (Python) from the paper's definition.
TEST(Noise, MatchesTheTable) {
  const struct {
    Vec3 p;
    double value;
  } rows[] = {{{0.5, 0.5, 0.5}, -0.25},
              {{-0.1, -0.2, -0.3}, -0.4157349393299456},
              {{1.25, -2.75, 100.125}, 0.02943564808811061},
              {{-255.9, 256.1, 511.7}, -0.14222890351089285},
              {{2147483648.5, -2147483649.25, 0.75}, 0.05979442596435547},
              {{1e12 + 0.125, 1e13 + 0.5, -1e10 - 0.3}, -0.1392688378791876},
              {{1e-9, 1e-5, 0.999999}, 9.989999900389955e-07}};
  for (const auto& row : rows) {
    EXPECT_NEAR(Noise().value(row.p), row.value, 1e-14);
  }
}

TEST(Noise, LatticeGradientsAreCubeEdges) {
  const Noise noise;
  for (int i = 0; i < 4096; ++i) {
    const NoiseSample s = noise.sample({i % 16, i / 16 % 16, i / 256});
    EXPECT_EQ(s.value, 0.0);
    EXPECT_EQ(glm::dot(s.gradient, s.gradient), 2.0);
    EXPECT_EQ(max_abs(s.gradient), 1.0);
  }
}

TEST(Noise, GradientIsTheDerivative) {
  const Noise noise(5);
  RandomPoints random(2);
  constexpr double h = 0x1p-17;  // central differences err by h^2/6 times a third derivative < 500
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random_point(random, 50.0);
    const NoiseSample s = noise.sample(p);
    EXPECT_EQ(s.value, noise.value(p));
    for (int k = 0; k < 3; ++k) {
      Vec3 step(0.0);
      step[k] = h;
      const double slope = (noise.value(p + step) - noise.value(p - step)) / (2 * h);
      EXPECT_NEAR(s.gradient[k], slope, 1e-8);
    }
  }
}

// Across a face of the lattice the second derivative, from both sides, is the same.
TEST(Noise, SecondDerivativeIsContinuousAcrossCells) {
  const Noise noise;
  RandomPoints random(3);
  constexpr double h = 1e-6;  // one-sided differences err by h times a third derivative < 500
  for (int i = 0; i < 500; ++i) {
    for (int k = 0; k < 3; ++k) {
      Vec3 p = random_point(random, 20.0);
      p[k] = std::floor(p[k]);
      Vec3 step(0.0);
      step[k] = h;
      const Vec3 here = noise.sample(p).gradient;
      const Vec3 after = (noise.sample(p + step).gradient - here) / h;
      const Vec3 before = (here - noise.sample(p - step).gradient) / h;
      EXPECT_LT(max_abs(after - before), 1e-3);
    }
  }
}

TEST(Noise, StaysWithinOne) {
  const Noise noise;
  RandomPoints random(4);
  for (int i = 0; i < 300000; ++i) {
    EXPECT_LE(std::abs(noise.value(random_point(random, 1000.0))), 1.0);
  }
  // The place of the largest magnitude of Perlin's formula, 1.036.
  EXPECT_EQ(std::abs(noise.value({12.3553, 187.519, 5.5})), 1.0);
  EXPECT_EQ(noise.sample({12.3553, 187.519, 5.5}).gradient, Vec3(0.0));
}

TEST(Noise, IsRightAtAnyCoordinate) {
  const Noise noise;
  const double inf = std::numeric_limits<double>::infinity();
  // The period is 256, and these sums are exact.
  for (double far : {256.0, -256.0, 0x1p31, -0x1p31, 0x1p40, -0x1p40, 0x1p45}) {
    const Vec3 p{0.375, 0.8125, 0.25};
    EXPECT_EQ(noise.value(p + far), noise.value(p)) << far;
    EXPECT_EQ(noise.value(p - Vec3(0, far, 0)), noise.value(p)) << far;
  }
  EXPECT_NE(noise.value(Vec3(0x1p31 + 0.5, 0.25, 0.75)), 0.0);
  for (double huge : {0x1p53, -0x1p60, 1e300, -1.7e308}) {
    EXPECT_EQ(noise.value({huge, 3, -huge}), 0.0);
  }
  for (double tiny : {1e-300, -1e-300, 5e-324, -5e-324, -1e-17}) {
    EXPECT_NEAR(noise.value({tiny, tiny, tiny}), 0.0, 1e-16);
  }
  for (double bad : {inf, -inf, static_cast<double>(NAN)}) {
    EXPECT_EQ(noise.value({bad, 0.5, 0.5}), 0.0);
    EXPECT_EQ(noise.value({0.5, 0.5, bad}), 0.0);
    EXPECT_EQ(noise.sample({0.5, bad, 0.5}).gradient, Vec3(0.0));
  }
}

TEST(Noise, SeedsDiffer) {
  const Vec3 p{1.3, 2.4, 3.7};
  EXPECT_NE(Noise(0).value(p), Noise(1).value(p));
  EXPECT_NE(Noise(1).value(p), Noise(2).value(p));
  EXPECT_EQ(Noise(2).value(p), Noise(2).value(p));
}

// 1.5% between permutations, and the standard error of 10^6 samples.
TEST(Noise, HasTheStatedMoments) {
  RandomPoints random(6);
  for (std::uint64_t seed : {0u, 9u}) {
    const Noise noise(seed);
    double sum = 0;
    double folded = 0;
    double squares = 0;
    constexpr int n = 1000000;
    for (int i = 0; i < n; ++i) {
      const double v = noise.value(random_point(random, 128.0));
      sum += v / n;
      folded += std::abs(v) / n;
      squares += v * v / n;
    }
    EXPECT_NEAR(sum, 0.0, 5e-3);
    EXPECT_NEAR(folded / noise_mean_abs, 1.0, 0.02);
    EXPECT_NEAR(squares / noise_variance, 1.0, 0.03);
  }
}

constexpr Octave octaves[] = {{1, 1}, {2, 0.5}, {4, 0.25}, {8, 0.125}};
constexpr NoiseKind kinds[] = {NoiseKind::fbm, NoiseKind::turbulence, NoiseKind::marble,
                               NoiseKind::wood};

TEST(Octaves, PatternsFillTheUnitIntervalAndAgreeWithTheirValue) {
  const Noise noise;
  RandomPoints random(7);
  for (NoiseKind kind : kinds) {
    for (int i = 0; i < 20000; ++i) {
      const Vec3 p = random_point(random, 40.0);
      const double footprint = 0.6 * random().x;
      const double value = pattern_value(noise, kind, octaves, p, footprint);
      EXPECT_GE(value, 0.0);
      EXPECT_LE(value, 1.0);
      EXPECT_EQ(value, pattern(noise, kind, octaves, p, footprint).value);
    }
  }
}

TEST(Octaves, GradientsAreDerivatives) {
  const Noise noise(3);
  RandomPoints random(8);
  constexpr double h = 0x1p-20;
  for (NoiseKind kind : kinds) {
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = random_point(random, 10.0);
      const double footprint = i % 2 ? 0.0 : 0.11;
      const Vec3 gradient = pattern(noise, kind, octaves, p, footprint).gradient;
      for (int k = 0; k < 3; ++k) {
        Vec3 step(0.0);
        step[k] = h;
        const double slope = (pattern_value(noise, kind, octaves, p + step, footprint) -
                              pattern_value(noise, kind, octaves, p - step, footprint)) /
                             (2 * h);
        EXPECT_NEAR(gradient[k], slope, 1e-6) << static_cast<int>(kind);
      }
    }
  }
}

TEST(Octaves, FarAwayOnlyTheMeanIsLeft) {
  const Noise noise;
  RandomPoints random(9);
  for (NoiseKind kind : kinds) {
    double mean = 0;
    constexpr int n = 100000;
    for (int i = 0; i < n; ++i) {
      mean += pattern_value(noise, kind, octaves, random_point(random, 128.0), 0.0) / n;
    }
    const double far = pattern_value(noise, kind, octaves, random_point(random, 9.0), 1.5);
    EXPECT_EQ(far, pattern_value(noise, kind, octaves, random_point(random, 9.0), 1.5));
    // Marble's stripes are in step with the lattice: its mean is 0.509, an effect left alone.
    EXPECT_NEAR(far, mean, kind == NoiseKind::marble ? 0.012 : 5e-3) << static_cast<int>(kind);
  }
}

// The mean over space does not change on the way there either.
TEST(Octaves, FadingKeepsTheMean) {
  const Noise noise;
  for (double footprint : {0.1, 0.2, 0.4, 0.8}) {
    RandomPoints random(10);
    double change = 0;
    constexpr int n = 100000;
    for (int i = 0; i < n; ++i) {
      const Vec3 p = random_point(random, 128.0);
      change += (pattern_value(noise, NoiseKind::turbulence, octaves, p, footprint) -
                 pattern_value(noise, NoiseKind::turbulence, octaves, p)) /
                n;
    }
    EXPECT_NEAR(change, 0.0, 2e-3) << footprint;
  }
}

TEST(Octaves, BandLimitFadesFromHalfACellToOne) {
  EXPECT_EQ(band_limit(3, 0.0), 1.0);
  EXPECT_EQ(band_limit(1, 0.5), 1.0);
  EXPECT_EQ(band_limit(1, 0.75), 0.5);
  EXPECT_EQ(band_limit(4, 0.25), 0.0);
  EXPECT_EQ(band_limit(1, std::numeric_limits<double>::infinity()), 0.0);
}

TEST(Octaves, DegenerateInputsGiveTheMean) {
  const Noise noise;
  const Octave none[] = {{1, 0}};
  for (NoiseKind kind : kinds) {
    const double mean = kind == NoiseKind::turbulence ? noise_mean_abs : 0.5;
    EXPECT_EQ(pattern_value(noise, kind, {}, {1, 2, 3}), mean);
    EXPECT_EQ(pattern_value(noise, kind, none, {1.5, 2, 3}), mean);
    EXPECT_EQ(pattern_value(noise, kind, octaves, {NAN, 2, 3}), mean);
  }
}

}  // namespace
}  // namespace rt
