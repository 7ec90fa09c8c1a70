// Textures: what a lookup gives at known places of known pictures, and what broken files give.
#include "rt/io/texture.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <thread>

#include "picture_bytes.h"
#include "rt/io/image.h"
#include "rt/math/srgb.h"
#include "rt/scene/error.h"
#include "rt/scene/texture.h"
#include "temp_folder.h"

namespace rt::io {
namespace {

/// Half rounds to 11 bits, so by 2^-11 of 1 and less; floats add a few roundings of 2^-24.
constexpr double half_precision = 1.0 / 2048;
constexpr double float_precision = 1e-6;

/// IEC 61966-2-1, once more.
double linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

class Textures : public testing::Test {
 protected:
  std::shared_ptr<const TextureImage> open(const std::string& content,
                                           const std::string& name = "picture",
                                           const TextureLimits& limits = {}) {
    put(folder_ / name, content);
    return open_texture(folder_ / name, limits);
  }
  std::string refusal(const std::string& content, const std::string& name = "picture") {
    const std::string message = message_of<FileError>([&] { open(content, name); });
    EXPECT_NE(message.find((folder_ / name).string()), std::string::npos) << message;
    return message;
  }
  /// The texel's own value: no footprint, at its centre.
  static Rgb point(const TextureImage& image, double u, double v, Wrap wrap = Wrap::repeat,
                   bool raw = false) {
    return image.value({{u, v}}, wrap, raw);
  }
  static Rgb over(const TextureImage& image, double width) {
    return image.value({{0.3, 0.7}, {width, 0}, {0, width}}, Wrap::repeat, false);
  }
  static void expect_rgb(const Rgb& got, const Rgb& expected, double tolerance) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(got[c], expected[c], tolerance) << "channel " << c;
    }
  }

  TempFolder folder_;
};

/// 4 x 2 texels of which no two are alike.
int sample_of(int column, int row, int channel) {
  return 20 + 60 * column + 25 * row + 3 * channel;
}
std::string distinct() {
  std::vector<std::string> rows(2);
  for (int row = 0; row < 2; ++row) {
    for (int k = 0; k < 12; ++k) {
      rows[static_cast<std::size_t>(row)] += static_cast<char>(sample_of(k / 3, row, k % 3));
    }
  }
  return png(4, 8, 2, rows);
}
Rgb texel(int column, int row) {
  const auto value = [&](int channel) { return linear(sample_of(column, row, channel) / 255.0); };
  return {value(0), value(1), value(2)};
}

TEST_F(Textures, StandUprightWithVUp) {
  const auto image = open(distinct());
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 2; ++row) {  // from the top
      expect_rgb(point(*image, (column + 0.5) / 4, 1 - (row + 0.5) / 2), texel(column, row),
                 half_precision);
    }
  }
  EXPECT_EQ(image->file(), folder_ / "picture");
}

TEST_F(Textures, InterpolateBetweenTexels) {
  const auto image = open(distinct());
  expect_rgb(point(*image, 0.5, 0.75), 0.5 * (texel(1, 0) + texel(2, 0)), half_precision);
  expect_rgb(point(*image, 0.125, 0.5), 0.5 * (texel(0, 0) + texel(0, 1)), half_precision);
}

TEST_F(Textures, WrapAsAsked) {
  const auto image = open(distinct());
  const double v = 0.75;
  for (const double whole : {-1e6, -3.0, 1.0, 1024.0, 1e9}) {
    // 1e9 + 0.125 is exact, and so is what is left of it without its whole part.
    expect_rgb(point(*image, whole + 0.125, v), texel(0, 0), half_precision);
  }
  expect_rgb(point(*image, 0.0, v), 0.5 * (texel(0, 0) + texel(3, 0)),
             half_precision);  // over the seam
  expect_rgb(point(*image, 1.0, v), 0.5 * (texel(0, 0) + texel(3, 0)), half_precision);
  for (const double edge : {0.0, -0.4, -17.0, -1e20}) {
    expect_rgb(point(*image, edge, v, Wrap::clamp), texel(0, 0), half_precision);
    expect_rgb(point(*image, 1.0 - edge, v, Wrap::clamp), texel(3, 0), half_precision);
  }
  expect_rgb(point(*image, -0.125, v, Wrap::mirror), texel(0, 0), half_precision);
  expect_rgb(point(*image, 1.125, v, Wrap::mirror), texel(3, 0), half_precision);
  expect_rgb(point(*image, 2.125, v, Wrap::mirror), texel(0, 0), half_precision);
  expect_rgb(point(*image, 0.125, -0.25, Wrap::mirror), texel(0, 1), half_precision);
  expect_rgb(point(*image, 0.125, 1.25, Wrap::mirror), texel(0, 0), half_precision);
  expect_rgb(point(*image, -0.5, v, Wrap::black), Rgb(0.0), 0.0);
  expect_rgb(point(*image, 0.5, 1e20, Wrap::black), Rgb(0.0), 0.0);
  expect_rgb(point(*image, 0.0, v, Wrap::black), 0.5 * texel(0, 0), half_precision);
}

TEST_F(Textures, LineariseEncodedPictures) {
  std::string row;
  for (int k = 0; k < 256; ++k) {
    row += static_cast<char>(k);
  }
  const auto image = open(png(256, 8, 0, {row}));
  for (int k = 0; k < 256; ++k) {
    const double u = (k + 0.5) / 256;
    const double stored = k / 255.0;
    expect_rgb(point(*image, u, 0.5), Rgb(linear(stored)),
               half_precision * stored + float_precision);
    expect_rgb(point(*image, u, 0.5, Wrap::repeat, true), Rgb(stored),
               half_precision * stored + float_precision);
  }
}

TEST_F(Textures, LineariseSixteenBits) {
  std::string row;
  for (const std::uint64_t value : {0U, 1U, 255U, 3000U, 32768U, 65535U}) {
    row += be(value, 2);
  }
  const auto image = open(png(6, 16, 0, {row}));
  int k = 0;
  for (const double value : {0.0, 1.0, 255.0, 3000.0, 32768.0, 65535.0}) {
    const double u = (k++ + 0.5) / 6;
    expect_rgb(point(*image, u, 0.5), Rgb(linear(value / 65535)), float_precision);
    expect_rgb(point(*image, u, 0.5, Wrap::repeat, true), Rgb(value / 65535), float_precision);
  }
}

TEST_F(Textures, LeaveFloatPicturesAsTheyAre) {
  write_image(folder_ / "bright.exr", {2, 1, {0.25F, 4.0F, -1.0F, 0.25F, 4.0F, -1.0F}},
              Encoding::srgb, {});
  const auto exr = open_texture(folder_ / "bright.exr");
  expect_rgb(point(*exr, 0.25, 0.5), {0.25, 4.0, -1.0}, 0.0);
  expect_rgb(point(*exr, 0.25, 0.5, Wrap::repeat, true), {0.25, 4.0, -1.0}, 0.0);
  // RGBE: mantissas over 256, times 2 to the exponent less 128.
  const auto hdr_image = open(hdr("-Y 1 +X 1", bytes({128, 64, 32, 130})));
  expect_rgb(point(*hdr_image, 0.5, 0.5), {2.0, 1.0, 0.5}, 4.0 / 256);
}

TEST_F(Textures, AverageInLinearLight) {
  // A checker of 1-texel squares, even and odd sizes alike; encoded, its mean would be 0.214.
  for (const std::uint32_t side : {64U, 63U, 200U, 1023U}) {
    std::vector<std::string> rows(side);
    double sum = 0.0;
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t x = 0; x < side; ++x) {
        const bool white = (x + y) % 2 != 0;
        rows[y] += white ? '\xff' : '\0';
        sum += white ? 1.0 : 0.0;
      }
    }
    const auto image = open(png(side, 8, 0, rows));
    const double mean = sum / (side * double{1} * side);
    // Ten levels, each rounded to half once.
    for (const double width : {0.5, 1.0, 3.0, 1000.0, 1e30}) {
      expect_rgb(over(*image, width), Rgb(mean), 10 * half_precision * mean + 0.5 / side);
    }
    expect_rgb(over(*image, std::numeric_limits<double>::infinity()), Rgb(mean),
               10 * half_precision * mean + 0.5 / side);
  }
}

TEST_F(Textures, KeepTheMeanOfAnyPicture) {
  std::mt19937 random(3);
  for (const auto& [width, height] :
       {std::pair{1, 1}, {1, 37}, {130, 1}, {3, 2}, {67, 129}, {255, 31}}) {
    Image picture{width, height, {}};
    Rgb sum(0.0);
    for (int k = 0; k < width * height; ++k) {
      for (int c = 0; c < 3; ++c) {
        picture.pixels.push_back(static_cast<float>(random() % 1000) / 1000.0F);
        sum[c] += double{picture.pixels.back()};
      }
    }
    write_image(folder_ / "noise.exr", picture, Encoding::srgb, {});
    const auto image = open_texture(folder_ / "noise.exr");
    expect_rgb(image->value({{0.5, 0.5}, {60, 0}, {0, 60}}, Wrap::repeat, false),
               sum / double(width * height), 10 * float_precision);
  }
}

TEST_F(Textures, GiveDerivatives) {
  // A ramp in u and, half as steep, in v: 0.01 a texel over 50.
  constexpr int side = 50;
  Image ramp{side, side, {}};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      ramp.pixels.insert(ramp.pixels.end(), 3,
                         0.01F * static_cast<float>(x) - 0.005F * static_cast<float>(y));
    }
  }
  write_image(folder_ / "ramp.exr", ramp, Encoding::srgb, {});
  const auto image = open_texture(folder_ / "ramp.exr");
  for (const double u : {0.3, 0.37, 0.5}) {
    const TextureSample s = image->sample({{u, 0.6}}, Wrap::clamp, true);
    // The B-spline of a straight line is that line: (u side - 1/2) 0.01, and v from below.
    expect_rgb(s.value, Rgb(0.01 * (u * side - 0.5) - 0.005 * (0.4 * side - 0.5)), 1e-5);
    expect_rgb(s.d_du, Rgb(0.5), 1e-4);
    expect_rgb(s.d_dv, Rgb(0.25), 1e-4);
  }
}

TEST_F(Textures, AreFiniteWhateverTheyAreAskedAndHold) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  write_image(folder_ / "bad.exr", {2, 2, {nan, 1, 2, inf, -inf, 0, 3e38F, -3e38F, 1, 1, 1, 1}},
              Encoding::srgb, {});
  const double odd[] = {0.0,    -0.0, 0.5,          1e-320, 1e300,
                        -1e300, 1e19, std::nan(""), inf,    -double{inf}};
  const auto all_finite = [](const Rgb& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
  };
  const auto image = open_texture(folder_ / "bad.exr");
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror, Wrap::black}) {
    for (const double a : odd) {
      for (const double b : odd) {
        for (const double c : odd) {
          const TextureFootprint footprint{{a, b}, {c, a}, {b, c}};
          const TextureSample s = image->sample(footprint, wrap, true);
          ASSERT_TRUE(all_finite(s.value) && all_finite(s.d_du) && all_finite(s.d_dv) &&
                      all_finite(image->value(footprint, wrap, false)))
              << a << ' ' << b << ' ' << c;
        }
      }
    }
  }
}

TEST_F(Textures, ReadOddPictures) {
  const auto first = [&](const std::string& content, const std::string& name = "odd") {
    return point(*open(content, name), 0.5, 0.5, Wrap::repeat, true);
  };
  const double k = 1.0 / 255;
  expect_rgb(first(png(1, 8, 4, {bytes({90, 10})})), Rgb(90 * k),
             half_precision);  // grey, alpha dropped
  expect_rgb(first(png(1, 8, 6, {bytes({90, 60, 30, 10})})), Rgb(90 * k, 60 * k, 30 * k),
             half_precision);
  expect_rgb(first(png(1, 8, 6, {bytes({90, 60, 30, 0})})), Rgb(90 * k, 60 * k, 30 * k),
             half_precision);
  expect_rgb(first(png(1, 1, 0, {bytes({0x80})})), Rgb(1.0), half_precision);
  expect_rgb(first(png(1, 16, 6, {be(6553500 / 100, 2) + be(0, 2) + be(32768, 2) + be(1, 2)})),
             Rgb(1.0, 0.0, 32768.0 / 65535), float_precision);
  const std::string palette = png_chunk("PLTE", bytes({1, 2, 3, 90, 60, 30}));
  expect_rgb(first(png(1, 8, 3, {bytes({1})}, palette)), Rgb(90 * k, 60 * k, 30 * k),
             half_precision);
  expect_rgb(first(bmp(1, 1, bytes({30, 60, 90, 0}))), Rgb(90 * k, 60 * k, 30 * k), half_precision);
  expect_rgb(first(tga(1, 1, 24, bytes({30, 60, 90})), "odd.tga"), Rgb(90 * k, 60 * k, 30 * k),
             half_precision);
  expect_rgb(first(tga(1, 1, 8, bytes({90})), "grey.tga"), Rgb(90 * k), half_precision);
  expect_rgb(first(tiff({{256, 1},
                         {257, 1},
                         {258, 8},
                         {259, 1},
                         {262, 1},
                         {273, 8},
                         {277, 1},
                         {278, 1},
                         {279, 1}},
                        bytes({90}))),
             Rgb(90 * k), half_precision);
  // An animated PNG: its first frame. The second, red, is in fdAT.
  const std::string frame = be(1, 4) + be(1, 4) + be(0, 8) + be(1, 2) + be(2, 2) + be(0, 2);
  expect_rgb(first(png(1, 8, 2, {bytes({90, 60, 30})},
                       png_chunk("acTL", be(2, 4) + be(0, 4)) + png_chunk("fcTL", be(0, 4) + frame),
                       png_chunk("fcTL", be(1, 4) + frame) +
                           png_chunk("fdAT", be(2, 4) + stored_zlib(bytes({0, 255, 0, 0}))))),
             Rgb(90 * k, 60 * k, 30 * k), half_precision);
  // CMYK (0, 1, 1, 0), up to JPEG's own error.
  const auto cmyk = open_texture(RT_SOURCE_DIR "/tests/unit/io/pictures/red_cmyk.jpg");
  expect_rgb(point(*cmyk, 0.5, 0.5), {1.0, 0.0, 0.0}, 0.03);
}

TEST_F(Textures, FindBrokenFilesWhenOpened) {
  const std::string long_row(3000, 'a');
  refusal(png(1000, 8, 2, {long_row, long_row}).substr(0, 3500));  // ends within its data
  refusal(png(1000, 8, 2, {long_row, long_row.substr(100)}));      // a row too short
  std::string damaged = png(1000, 8, 2, {long_row, long_row});
  damaged[60] = static_cast<char>(damaged[60] ^ 0x55);  // a block's length
  refusal(damaged);
  refusal(png_start(4, 4, 8, 2));
  refusal(hdr("-Y 7 +X 6", "ab"));
  refusal(exr_header(10, 11));
  refusal(tiff({{256, 1},
                {257, 1},
                {258, 8},
                {259, 1},
                {262, 1},
                {273, 80'000},
                {277, 1},
                {278, 1},
                {279, 1}},
               "a"));
}

TEST_F(Textures, RefuseTilesThatTakeMoreThanAPictureMay) {
  put(folder_ / "tall", tiff({{256, 1},
                              {257, 1},
                              {258, 8},
                              {259, 1},
                              {262, 1},
                              {277, 1},
                              {322, 16},
                              {323, 4096},
                              {324, 8},
                              {325, 16 * 4096}},
                             std::string(16 * 4096, 'a')));
  TextureLimits limits;
  EXPECT_NO_THROW(open_texture(folder_ / "tall", limits));
  limits.decoded_bytes = 200'000;  // as floats they take 262'144
  const std::string message =
      message_of<FileError>([&] { open_texture(folder_ / "tall", limits); });
  EXPECT_NE(message.find("tiles of 16 x 4096 pixels"), std::string::npos) << message;
}

TEST_F(Textures, FindWholeFilesThatWereCutShort) {
  std::mt19937 random(5);
  Image picture{90, 70, {}};
  for (int k = 0; k < 90 * 70 * 3; ++k) {
    picture.pixels.push_back(static_cast<float>(random() % 256) / 255.0F);
  }
  for (const std::string extension : {".png", ".jpg", ".bmp", ".tga", ".exr"}) {
    const auto file = folder_ / ("whole" + extension);
    write_image(file, picture, Encoding::raw, {});
    EXPECT_NO_THROW(open_texture(file)) << extension;
    const std::string whole = bytes_of(file);
    for (const double part : {0.05, 0.3, 0.6, 0.95}) {
      SCOPED_TRACE(extension + " " + std::to_string(part));
      refusal(whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))),
              "short" + extension);
    }
  }
}

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

TEST_F(Textures, RefuseBombsAtOnce) {
  open(distinct());  // what loads, has loaded
  const auto memory = peak_memory();
  const auto begin = std::chrono::steady_clock::now();
  const std::string bomb = png_bomb(60'000);
  ASSERT_LT(bomb.size(), 71'000U);
  const std::string message = refusal(bomb);
  EXPECT_NE(message.find("60000 x 60000"), std::string::npos) << message;
  refusal(png_bomb(16'000));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
  EXPECT_LT(peak_memory() - memory, std::uint64_t{50} << 20);
}

/// Many lookups, as one list.
std::vector<Rgb> lookups(const TextureImage& image, unsigned seed) {
  std::vector<Rgb> all;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int k = 0; k < 4000; ++k) {
    const double width = std::pow(2.0, -10.0 * unit(random));
    all.push_back(
        image.value({{unit(random), unit(random)}, {width, 0.1 * width}, {0, 0.2 * width}},
                    Wrap::repeat, k % 2 == 0));
  }
  return all;
}

TEST_F(Textures, AreTheSameForAnyThreadAndAnyCache) {
  std::mt19937 random(7);
  constexpr std::uint32_t side = 1500;
  std::vector<std::string> rows(side);
  for (std::string& row : rows) {
    for (std::uint32_t k = 0; k < 3 * side; ++k) {
      row += static_cast<char>(random() % 256);
    }
  }
  const auto image = open(png(side, 8, 2, rows));  // 18 MB with its averages, and as much raw
  std::vector<std::vector<Rgb>> expected;
  for (unsigned seed = 0; seed < 8; ++seed) {
    expected.push_back(lookups(*image, seed));
  }
  TextureLimits small;
  small.cache_megabytes = 2;
  const auto again = open(png(side, 8, 2, rows), "again", small);
  std::vector<std::vector<Rgb>> got(8);
  {
    std::vector<std::jthread> threads;
    for (unsigned seed = 0; seed < 8; ++seed) {
      threads.emplace_back([&, seed] { got[seed] = lookups(*again, seed); });
    }
  }
  EXPECT_EQ(got, expected);
  // Threads wait at twice the limit, each with one more tile of 24 KB and the cache's bookkeeping.
  EXPECT_LT(texture_statistics().cache_peak, std::uint64_t{5} << 20);
  EXPECT_GT(texture_statistics().cache_peak, std::uint64_t{1} << 20);
  open(distinct());  // the usual cache again
}

TEST_F(Textures, CountThemselves) {
  const TextureStatistics before = texture_statistics();
  const auto image = open(distinct());
  for (int k = 0; k < 10; ++k) {
    point(*image, 0.1 * k, 0.5);
  }
  const TextureStatistics after = texture_statistics();
  EXPECT_EQ(after.files, before.files + 1);
  EXPECT_EQ(after.lookups, before.lookups + 10);
  EXPECT_GT(after.cache_peak, 0U);
  EXPECT_GT(after.load_seconds, before.load_seconds);
}

}  // namespace
}  // namespace rt::io
