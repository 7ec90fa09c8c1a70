#include "z_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rt::images {
namespace {

constexpr int count = 64;

/// Noise about a gradient; a quarter of the pixels has none.
io::Image noisy(unsigned seed, double shift = 0.0, double widen = 1.0) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  io::Image image{48, 32, {}};
  for (int i = 0; i < 48 * 32 * 3; ++i) {
    const double sigma = i % 4 == 0 ? 0.0 : 0.01 + 0.02 * (i % 7);
    const double z = normal(random);
    image.pixels.push_back(static_cast<float>(i % 97 / 97.0 + sigma * (shift + widen * z)));
  }
  return image;
}

Reference reference() {
  std::vector<io::Image> pictures;
  for (unsigned seed = 0; seed < count; ++seed) {
    pictures.push_back(noisy(seed));
  }
  return reference_of(pictures);
}

TEST(ZTest, AcceptsFairDraws) {
  const Reference r = reference();
  for (unsigned seed = 100; seed < 150; ++seed) {
    const ZVerdict verdict = z_test(noisy(seed), r, count);
    EXPECT_TRUE(verdict.fair) << seed << "\n" << verdict.text;
  }
}

TEST(ZTest, RejectsABrighterAndANoisierPicture) {
  const Reference r = reference();
  EXPECT_FALSE(z_test(noisy(100, 0.2), r, count).fair);
  EXPECT_FALSE(z_test(noisy(100, 0.0, 1.15), r, count).fair);
}

TEST(ZTest, RejectsSpotsWhereNothingIsRandomAndNaN) {
  const Reference r = reference();
  for (const float bad : {1e-3F, std::nanf("")}) {
    io::Image spotted = noisy(100);
    for (std::size_t i = 0; i < 400; i += 4) {
      spotted.pixels[i] += bad;
    }
    EXPECT_FALSE(z_test(spotted, r, count).fair) << bad;
  }
}

TEST(ZTest, RejectsAnotherSize) {
  io::Image small = noisy(100);
  small.height -= 1;
  EXPECT_FALSE(z_test(small, reference(), count).fair);
}

}  // namespace
}  // namespace rt::images
