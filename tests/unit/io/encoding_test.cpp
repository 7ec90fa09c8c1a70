#include "rt/io/encoding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rt::io {
namespace {

TEST(Encoding, KnowsPointsOfTheStandardCurve) {
  EXPECT_EQ(srgb_oetf(0.0), 0.0);
  EXPECT_NEAR(srgb_oetf(1.0), 1.0, 1e-15);
  EXPECT_NEAR(srgb_oetf(0.001), 0.01292, 1e-15);
  EXPECT_NEAR(srgb_oetf(0.0031308), 0.040449936, 1e-12);
  // 1.055 * 0.5^(1/2.4) - 0.055 and 1.055 * 0.18^(1/2.4) - 0.055, by an independent calculator.
  EXPECT_NEAR(srgb_oetf(0.5), 0.735356983052449, 1e-12);
  EXPECT_NEAR(srgb_oetf(0.18), 0.461356129500442, 1e-12);
}

TEST(Encoding, GivesKnownCodes) {
  EXPECT_EQ(encode8(0.0F, Encoding::srgb), 0);
  EXPECT_EQ(encode8(0.5F, Encoding::srgb), 188);
  EXPECT_EQ(encode8(0.18F, Encoding::srgb), 118);
  EXPECT_EQ(encode8(0.2140F, Encoding::srgb), 127);  // 127.5 lies at 0.21404114
  EXPECT_EQ(encode8(0.2141F, Encoding::srgb), 128);
  EXPECT_EQ(encode8(1.0F, Encoding::srgb), 255);
  EXPECT_EQ(encode8(0.5F, Encoding::raw), 128);
  EXPECT_EQ(encode8(0.25F, Encoding::raw), 64);
  EXPECT_EQ(encode8(0.1F, Encoding::raw), 26);
}

TEST(Encoding, IsTheRoundedFormulaEverywhere) {
  for (int i = 0; i <= 2000000; ++i) {
    const auto value = static_cast<float>(i / 2000000.0);
    const double exact = 255.0 * srgb_oetf(double{value});
    ASSERT_LE(std::abs(encode8(value, Encoding::srgb) - exact), 0.5 + 1e-9) << value;
    ASSERT_EQ(encode8(value, Encoding::raw), std::floor(255.0 * double{value} + 0.5)) << value;
  }
}

TEST(Encoding, GoesBackAndForthOnEveryCode) {
  for (int code = 0; code <= 255; ++code) {
    const double s = code / 255.0;
    const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    EXPECT_EQ(encode8(static_cast<float>(linear), Encoding::srgb), code);
    EXPECT_EQ(encode8(static_cast<float>(s), Encoding::raw), code);
  }
}

TEST(Encoding, SurvivesWhatIsNoColour) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const auto encoding : {Encoding::srgb, Encoding::raw}) {
    EXPECT_EQ(encode8(std::numeric_limits<float>::quiet_NaN(), encoding), 0);
    EXPECT_EQ(encode8(infinity, encoding), 255);
    EXPECT_EQ(encode8(-infinity, encoding), 0);
    EXPECT_EQ(encode8(-1.0F, encoding), 0);
    EXPECT_EQ(encode8(7.0F, encoding), 255);
    EXPECT_EQ(encode8(std::nextafter(1.0F, 0.0F), encoding), 255);
    EXPECT_EQ(encode8(std::numeric_limits<float>::denorm_min(), encoding), 0);
  }
}

}  // namespace
}  // namespace rt::io
