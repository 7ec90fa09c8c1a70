#pragma once
/// From linear light to the 8-bit numbers of a file, and back.
#include <cmath>
#include <cstdint>
#include <vector>

#include "rt/io/image.h"
#include "rt/math/srgb.h"

namespace rt::io {

/// The electro-optical transfer function of IEC 61966-2-1 (sRGB), the inverse of srgb_oetf(). Here
/// and inline because OpenImageIO's module, which links no layer, wants it too.
inline double srgb_eotf(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// 255 times the value, or its sRGB encoding, rounded to the nearest and clamped to 0..255.
/// NaN becomes 0, so that one bad pixel does not cost the picture.
std::uint8_t encode8(float linear, Encoding encoding);

/// encode8 of every channel of every pixel.
std::vector<std::uint8_t> encode8(const Image& image, Encoding encoding);

}  // namespace rt::io
