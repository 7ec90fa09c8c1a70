#include "rt/cli/html_report.h"

#include <gtest/gtest.h>

namespace rt::cli {
namespace {

std::string encoded(std::string_view text) {
  return base64({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

/// The examples of RFC 4648, section 10.
TEST(Base64, Rfc4648) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encoded("\xff\xff\xff"), "////");
}

TEST(ErrorMap, BlueBelowTheTargetAndRedAbove) {
  const Rgb at = error_colour(0.02, 0.02);
  EXPECT_EQ(at.r, at.b);
  const Rgb below = error_colour(0.005, 0.02);
  EXPECT_GT(below.b, below.r);
  const Rgb above = error_colour(0.08, 0.02);
  EXPECT_GT(above.r, above.b);
  EXPECT_EQ(error_colour(0.0, 0.02), error_colour(0.02 / 16, 0.02));
}

TEST(SampleMap, LightensWithTheCountAndStandsOneCountAlone) {
  EXPECT_LT(count_colour(4, 4, 64).g, count_colour(16, 4, 64).g);
  EXPECT_LT(count_colour(16, 4, 64).g, count_colour(64, 4, 64).g);
  EXPECT_EQ(count_colour(4, 4, 4), count_colour(4, 4, 64));
}

}  // namespace
}  // namespace rt::cli
