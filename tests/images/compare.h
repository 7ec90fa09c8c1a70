#pragma once
/// How far two pictures are apart, and whether that is near enough.
#include <cstddef>
#include <optional>
#include <string>

#include "rt/io/image.h"

namespace rt::images {

/// Differences are of stored values: 1/255 is one step of an 8-bit picture.
struct Difference {
  double max = 0.0;              ///< over all channels of all pixels
  double mean = 0.0;             ///< likewise
  std::size_t pixels = 0;        ///< pixels that differ at all, in any channel
  std::size_t pixels_above = 0;  ///< pixels that differ by more than `above`
};

/// What is allowed; where nothing is, the pictures must be equal.
struct Tolerance {
  std::optional<double> max = {};
  std::optional<double> mean = {};
  std::optional<std::size_t> count = {};  ///< of pixels that differ by more than `above`
  double above = 0.0;
};

struct Verdict {
  bool near_enough = false;
  std::string text;  ///< the difference, and what exceeds the tolerance
};

/// Pictures of different sizes, and a NaN or an infinity in either, are never near enough.
Verdict compare(const io::Image& a, const io::Image& b, const Tolerance& tolerance);

}  // namespace rt::images
