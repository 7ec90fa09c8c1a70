// The textures that come with the program: small, and seamless also once compressed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "rt/io/image.h"

namespace rt::io {
namespace {

/// The mean difference of each column from the next, the first following the last.
std::vector<double> column_steps(const Image& image, bool of_rows) {
  const auto across = static_cast<std::size_t>(of_rows ? image.height : image.width);
  const auto along = static_cast<std::size_t>(of_rows ? image.width : image.height);
  const auto at = [&](std::size_t column, std::size_t k, std::size_t channel) {
    const std::size_t x = of_rows ? k : column;
    const std::size_t y = of_rows ? column : k;
    return double{image.pixels[3 * (y * static_cast<std::size_t>(image.width) + x) + channel]};
  };
  std::vector<double> steps;
  for (std::size_t column = 0; column < across; ++column) {
    double sum = 0.0;
    for (std::size_t k = 0; k < along; ++k) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        sum += std::abs(at((column + 1) % across, k, channel) - at(column, k, channel));
      }
    }
    steps.push_back(sum / static_cast<double>(3 * along));
  }
  return steps;
}

class ShippedTextures : public testing::TestWithParam<const char*> {};

TEST_P(ShippedTextures, ContinueOverTheirEdges) {
  const auto file = std::filesystem::path(RT_SOURCE_DIR) / "textures" / GetParam();
  EXPECT_LE(std::filesystem::file_size(file), 1U << 20);
  const Image image = read_image(file);
  for (const bool of_rows : {false, true}) {
    std::vector<double> steps = column_steps(image, of_rows);
    const double seam = steps.back();
    std::ranges::sort(steps);
    // No more of a step than the hundredth that is steepest; two levels are the coding's noise.
    EXPECT_LE(seam, 1.5 * steps[steps.size() * 99 / 100] + 2.0 / 255) << of_rows;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedTextures,
                         testing::Values("brick.jpg", "marble.jpg", "wood.jpg", "grid.png"),
                         [](const auto& instance) {
                           const std::string name = instance.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(SeamTest, NoticesASeam) {
  Image ramp{64, 64, {}};
  for (int k = 0; k < 64 * 64; ++k) {
    ramp.pixels.insert(ramp.pixels.end(), 3, static_cast<float>(k % 64) / 64.0F);
  }
  const std::vector<double> steps = column_steps(ramp, false);
  EXPECT_GT(steps.back(), 1.5 * steps.front() + 2.0 / 255);
}

}  // namespace
}  // namespace rt::io
