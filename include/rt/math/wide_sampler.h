#pragma once
#include <array>

#include "rt/math/sampler.h"
#include "rt/math/wide.h"

namespace rt {

/// The samplers of several samples (sampler.h), which draw together: lane by lane the same numbers.
class WideSampler {
 public:
  /// Draws nothing sensible before every lane has been set.
  WideSampler() = default;

  /// Lane `lane` becomes sample `index` of pixel (x, y); lanes are set in order.
  void set(int lane, std::uint64_t seed, int x, int y, std::uint32_t index) {
    const auto i = static_cast<std::size_t>(lane);
    const bool again = i > 0 && x == x_ && y == y_;
    keys_[i] = again ? keys_[i - 1] : Sampler::key_of(seed, x, y);
    x_ = x;
    y_ = y;
    indices_[i] = index;
  }
  /// To be called when all lanes are set.
  void begin() { points_ = shuffled(keys_); }

  /// Of one lane.
  Sampler lane(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return {keys_[at], indices_[at], points_[at]};
  }

  Wide2 pixel() const { return draw2(keys_, points_, 0, 0, 1); }

 private:
  using Words = stdx::rebind_simd_t<std::uint32_t, Wide>;
  using Keys = std::array<std::uint64_t, lanes>;

  /// Once for lanes side by side of one pixel.
  static Keys mixed(const Keys& keys, std::uint64_t multiple) {
    Keys out;
    for (std::size_t i = 0; i < lanes; ++i) {
      out[i] = i > 0 && keys[i] == keys[i - 1] ? out[i - 1] : mix64(keys[i] + multiple * golden64);
    }
    return out;
  }

  static Words reverse(const Words& x) {
    const Words bytes = reverse_bits_of_bytes(x);
    return (bytes >> 24) | ((bytes >> 8) & 0xff00u) | ((bytes << 8) & 0xff0000u) | (bytes << 24);
  }
  static Words words(const Keys& keys, int shift) {
    return Words([&](auto i) { return static_cast<std::uint32_t>(keys[i] >> shift); });
  }

  Words shuffled(const Keys& keys) const {
    const Words seeds = words(mixed(keys, 255), 0);
    const Words index([&](auto i) { return indices_[i]; });
    const Words low = reverse(owen_reversed(reverse(index << 16), seeds)) >> 16;
    return (index & 0xffff0000u) | low;
  }
  /// Dimension 1, whose matrix is Pascal's: bit i is the sum of all bits whose numbers contain i's
  /// bits.
  static Words pascal(Words x) {
    x ^= (x >> 1) & 0x55555555u;
    x ^= (x >> 2) & 0x33333333u;
    x ^= (x >> 4) & 0x0f0f0f0fu;
    x ^= (x >> 8) & 0x00ff00ffu;
    return x ^ (x >> 16);
  }
  static Wide coordinate(const Words& points, int dimension, const Words& seeds) {
    const Words x = dimension == 0   ? points  // its matrix is the identity
                    : dimension == 1 ? pascal(points)
                                     : Words([&](auto i) {
                                         return sobol_reversed(points[i], dimension);
                                       });
    const Words bits = reverse(owen_reversed(x, seeds));
    return (stdx::static_simd_cast<Wide>(bits) + 0.5) * 0x1p-32;
  }
  Wide2 draw2(const Keys& keys, const Words& points, std::uint64_t decision, int d0, int d1) const {
    const Keys seeds = mixed(keys, decision + 1);
    return {coordinate(points, d0, words(seeds, 0)), coordinate(points, d1, words(seeds, 32))};
  }

  Keys keys_{};
  std::array<std::uint32_t, lanes> indices_{};
  Words points_{0u};
  int x_ = 0, y_ = 0;
};

}  // namespace rt
