#pragma once
/// From linear light to the 8-bit numbers of a file.
#include <cstdint>
#include <vector>

#include "rt/io/image.h"
#include "rt/math/srgb.h"

namespace rt::io {

/// 255 times the value, or its sRGB encoding, rounded to the nearest and clamped to 0..255.
/// NaN becomes 0, so that one bad pixel does not cost the picture.
std::uint8_t encode8(float linear, Encoding encoding);

/// encode8 of every channel of every pixel.
std::vector<std::uint8_t> encode8(const Image& image, Encoding encoding);

}  // namespace rt::io
