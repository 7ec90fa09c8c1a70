#include "rt/io/encoding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::io {
namespace {

/// Rounding to the nearest code is a search for the last threshold that is not above the value; a
/// table says where to begin, and no power is computed per pixel.
struct SrgbTable {
  static constexpr int buckets = 4096;
  /// The smallest linear value whose encoding rounds to the code; beyond 255, nothing does.
  std::array<double, 257> threshold{};
  /// The code of each bucket's lower end.
  std::array<std::uint8_t, buckets> first{};

  SrgbTable() {
    for (int code = 0; code <= 255; ++code) {
      threshold[static_cast<std::size_t>(code)] = code == 0 ? 0.0 : srgb_eotf((code - 0.5) / 255.0);
    }
    threshold[256] = INFINITY;
    for (int bucket = 0; bucket < buckets; ++bucket) {
      const double encoded = 255.0 * srgb_oetf(bucket / double{buckets});
      // One below the rounded value: the search below only ever goes up.
      first[static_cast<std::size_t>(bucket)] =
          static_cast<std::uint8_t>(std::max(0.0, std::floor(encoded + 0.5) - 1.0));
    }
  }

  std::uint8_t operator()(double linear) const {  // in [0,1)
    std::size_t code = first[static_cast<std::size_t>(linear * buckets)];
    while (linear >= threshold[code + 1]) {
      ++code;
    }
    return static_cast<std::uint8_t>(code);
  }
};

}  // namespace

std::uint8_t encode8(float linear, Encoding encoding) {
  static const SrgbTable srgb;
  if (!(linear > 0.0F)) {  // NaN too
    return 0;
  }
  if (linear >= 1.0F) {
    return 255;
  }
  return encoding == Encoding::srgb
             ? srgb(linear)
             : static_cast<std::uint8_t>(std::lround(255.0 * double{linear}));
}

std::vector<std::uint8_t> encode8(const Image& image, Encoding encoding) {
  std::vector<std::uint8_t> codes;
  codes.reserve(image.pixels.size());
  for (const float value : image.pixels) {
    codes.push_back(encode8(value, encoding));
  }
  return codes;
}

}  // namespace rt::io
