#pragma once
/// A digital sequence of Sobol's kind, unscrambled: 32 bits a coordinate, 2^32 points.
#include <array>
#include <cstdint>

namespace rt {

/// Dimensions at hand, numbered from 0. The first four are jointly a (0,4)-sequence in base 4, and
/// (0,1) and (2,3) are each a (0,2)-sequence in base 2, the best there can be; Sobol's own 3rd and
/// 4th dimensions are far from that (8 samples of a light in them err by 1.4 times as much).
/// The others are Joe and Kuo's rows 4, 7, 9, 12 and 13.
inline constexpr int sobol_dimensions = 9;

/// The sums (over GF(2)) of a dimension's direction numbers, bits reversed, by the index' nibbles:
/// eight look-ups replace up to 32 exclusive-ors.
using SobolTable = std::array<std::array<std::array<std::uint32_t, 16>, 8>, sobol_dimensions>;
extern const SobolTable sobol_table;

/// Coordinate `dimension` of point `index`: bit 0 is worth 1/2, bit 1 is worth 1/4, ... The
/// reversal is what scrambling works on; reverse_bits gives the usual order.
inline std::uint32_t sobol_reversed(std::uint32_t index, int dimension) {
  const auto& t = sobol_table[static_cast<std::size_t>(dimension)];
  std::uint32_t x = t[0][index & 15u] ^ t[1][(index >> 4) & 15u] ^ t[2][(index >> 8) & 15u] ^
                    t[3][(index >> 12) & 15u];
  if (index >= 0x10000u) {  // rare: more than 65536 samples a pixel
    x ^= t[4][(index >> 16) & 15u] ^ t[5][(index >> 20) & 15u] ^ t[6][(index >> 24) & 15u] ^
         t[7][index >> 28];
  }
  return x;
}

}  // namespace rt
