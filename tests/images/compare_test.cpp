/// The comparator must be able to fail: a test by pictures is worth no more than that.
#include "compare.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "unit/io/temp_folder.h"

namespace rt::images {
namespace {

constexpr int side = 32;
constexpr float step = 1.0F / 255.0F;

io::Image picture() {
  io::Image image{side, side, {}};
  for (int i = 0; i < side * side * 3; ++i) {
    image.pixels.push_back(static_cast<float>((i * 7919) % 256) * step);
  }
  return image;
}

io::Image shifted() {
  const io::Image original = picture();
  io::Image image = original;
  for (std::size_t i = 3; i < image.pixels.size(); ++i) {
    image.pixels[i] = original.pixels[i - 3];
  }
  return image;
}

/// The tolerance of the regression tests, see README.md.
Tolerance regression() { return {.max = {}, .mean = 0.0005, .count = 4, .above = 0.004}; }

TEST(Compare, PassesEqualPictures) {
  const auto verdict = compare(picture(), picture(), {});
  EXPECT_TRUE(verdict.near_enough);
  EXPECT_EQ(verdict.text, "maximum 0, mean 0, 0 of 1024 pixels differ");
}

TEST(Compare, FailsOnOneValueByOneStep) {
  io::Image other = picture();
  other.pixels[1500] += step;
  EXPECT_FALSE(compare(picture(), other, {}).near_enough);
  EXPECT_FALSE(compare(picture(), other, {.max = 0.9 * step}).near_enough);
  EXPECT_TRUE(compare(picture(), other, {.max = 1.1 * step}).near_enough);
  EXPECT_FALSE(compare(picture(), other, {.count = 0}).near_enough);
  EXPECT_TRUE(compare(picture(), other, {.count = 1}).near_enough);
  EXPECT_TRUE(compare(picture(), other, {.count = 0, .above = 1.1 * step}).near_enough);
  EXPECT_FALSE(compare(picture(), other, {.mean = 1e-9}).near_enough);
  EXPECT_TRUE(compare(picture(), other, {.mean = step}).near_enough);
}

TEST(Compare, ReportsMaximumMeanAndCount) {
  io::Image other = picture();
  other.pixels[0] += 0.5F;
  other.pixels[1] += 0.25F;
  other.pixels[9] += 0.25F;
  const auto verdict = compare(picture(), other, {.max = 1.0});
  EXPECT_EQ(verdict.text, "maximum 0.5, mean 0.000325521, 2 of 1024 pixels differ");
}

TEST(Compare, FailsWhenAnyOfSeveralLimitsIsExceeded) {
  io::Image other = picture();
  other.pixels[0] += 0.5F;
  EXPECT_FALSE(compare(picture(), other, {.max = 0.1, .mean = 1.0, .count = 9}).near_enough);
  EXPECT_FALSE(compare(picture(), other, {.max = 1.0, .mean = 1e-6, .count = 9}).near_enough);
  EXPECT_FALSE(compare(picture(), other, {.max = 1.0, .mean = 1.0, .count = 0}).near_enough);
}

TEST(Compare, RegressionToleranceFailsOnDamage) {
  EXPECT_TRUE(compare(picture(), picture(), regression()).near_enough);
  EXPECT_FALSE(compare(picture(), shifted(), regression()).near_enough);
  io::Image brighter = picture();
  for (float& value : brighter.pixels) {
    value += 0.9F * step;
  }
  EXPECT_FALSE(compare(picture(), brighter, regression()).near_enough) << "everywhere a little";
  io::Image spotted = picture();
  for (std::size_t i = 0; i < 5; ++i) {
    spotted.pixels[300 * i] += 2.0F * step;
  }
  EXPECT_FALSE(compare(picture(), spotted, regression()).near_enough) << "five pixels";
}

TEST(Compare, FailsOnNaNAndInfinityInEither) {
  for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    io::Image other = picture();
    other.pixels.back() = bad;
    const Tolerance generous{.max = 1e30, .mean = 1e30, .count = 1000000};
    EXPECT_FALSE(compare(picture(), other, generous).near_enough);
    EXPECT_FALSE(compare(other, picture(), generous).near_enough);
    EXPECT_FALSE(compare(other, other, generous).near_enough);
    EXPECT_FALSE(compare(other, other, {}).near_enough);
  }
}

TEST(Compare, FailsOnAnotherSize) {
  io::Image wide{2, 1, std::vector<float>(6, 0.0F)};
  io::Image high{1, 2, std::vector<float>(6, 0.0F)};
  EXPECT_FALSE(compare(wide, high, {.max = 1.0}).near_enough);
}

/// The program itself, on files.
class CompareImages : public testing::Test {
 protected:
  int exit_code(const std::string& arguments) const {
    const std::string command =
        fmt::format("'{}' {} >'{}' 2>&1", COMPARE_IMAGES, arguments, (folder_ / "log").string());
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string file(const std::string& name, const io::Image& image) const {
    io::write_image(folder_ / name, image, Encoding::raw, {});
    return fmt::format("'{}' ", (folder_ / name).string());
  }
  io::TempFolder folder_;
};

TEST_F(CompareImages, GivesExitCodes) {
  const std::string a = file("a.png", picture());
  EXPECT_EQ(exit_code(a + a), 0);
  EXPECT_EQ(exit_code(a + file("copy.exr", picture()) + "--max 1e-6"), 0);
  EXPECT_EQ(exit_code(a + file("shifted.png", shifted())), 1);
  EXPECT_EQ(exit_code(a + file("shifted.png", shifted()) + "--mean 0.0005 --count 4 --above 0.004"),
            1);
  EXPECT_EQ(exit_code(a + file("shifted.png", shifted()) + "--max 1"), 0);
  EXPECT_EQ(exit_code(a + file("dot.png", {1, 1, {0, 0, 0}}) + "--max 1"), 1);
}

TEST_F(CompareImages, FailsOnNaNAndInfinityInFiles) {
  io::Image image = picture();
  image.pixels[5] = std::nanf("");
  const std::string nan = file("nan.exr", image);
  EXPECT_EQ(exit_code(nan + nan + "--max 1"), 1);
  image.pixels[5] = std::numeric_limits<float>::infinity();
  const std::string infinite = file("inf.exr", image);
  EXPECT_EQ(exit_code(infinite + infinite), 1);
}

TEST_F(CompareImages, RefusesWhatItCannotUnderstand) {
  const std::string a = file("a.png", picture());
  for (const char* rest : {"", "missing.png", "--max 1", "--max", "--max x", "--max nan",
                           "--max -1", "--mean inf", "--near 1", "a b"}) {
    EXPECT_EQ(exit_code(a + rest), 2) << rest;
  }
  EXPECT_EQ(exit_code(a + a + "--max"), 2);
  EXPECT_EQ(exit_code(a + a + "--max nan"), 2);
  EXPECT_EQ(exit_code(""), 2);
}

}  // namespace
}  // namespace rt::images
