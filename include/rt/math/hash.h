#pragma once
/// Integer hashes: the only source of randomness in the program. They use integer arithmetic modulo
/// 2^32 and 2^64 alone, so every machine draws the same numbers.
#include <cstdint>

namespace rt {

/// A bijection of 64 bits in which every input bit changes every output bit with probability near
/// 1/2. Source: Stafford's variant 13 of the MurmurHash3 finaliser, as used by SplitMix64 (Steele,
/// Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014). U: 64 bits, or a
/// vector of such.
template <class U>
constexpr U mix64(U x) {
  static_assert(sizeof(x >> 1) % sizeof(std::uint64_t) == 0);
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// 2^64 / golden ratio, odd: multiples of it are far apart, so small integers become good keys.
inline constexpr std::uint64_t golden64 = 0x9e3779b97f4a7c15u;

/// A key that depends on both arguments, and on their order. U: as above.
template <class U>
constexpr U combine(std::uint64_t key, const U& value) {
  return mix64(key ^ mix64(value + golden64));
}

/// Within every byte, bit 0 becomes bit 7, and so on. U: 32 bits, or a vector of such.
template <class U>
constexpr U reverse_bits_of_bytes(U x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
}

/// Bit 0 becomes bit 31, and so on.
constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  return __builtin_bswap32(reverse_bits_of_bytes(x));
}

/// Owen's nested uniform scrambling of a number whose bits are reversed, least significant first:
/// each bit is flipped or not by a hash of the bits below it and of `seed`. This holds because
/// addition, multiplication by an odd constant and x ^= x * even carry information upward only.
/// Idea: Laine and Karras, "Stratified sampling for stochastic transparency" (EGSR 2011), and
/// Burley, "Practical hash-based Owen scrambling" (JCGT 9(4), 2020); this sequence of operations
/// and its constants: Vegdahl, "Building a better LK hash" (psychopath.io, 2021), final version.
/// Expects seeds that are themselves well mixed. U: 32 bits, or a vector of such.
template <class U>
constexpr U owen_reversed(U x, U seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// The centre of the cell [x, x+1) / 2^32: a number in (0,1), never 0 nor 1.
constexpr double unit_interval(std::uint32_t x) { return (x + 0.5) * 0x1p-32; }

}  // namespace rt
