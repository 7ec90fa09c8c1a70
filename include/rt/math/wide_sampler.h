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

  /// Lane `lane` becomes sample `index` of pixel (x, y).
  void set(int lane, int x, int y, std::uint32_t index) {
    const auto i = static_cast<std::size_t>(lane);
    places_[i] = Sampler::place_of(x, y);
    indices_[i] = index;
  }
  /// To be called when all lanes are set.
  void begin(std::uint64_t seed) {
    keys_ = combine(seed, Keys(places_.data(), stdx::element_aligned));
    points_ = shuffled(keys_);
  }

  /// Of one lane.
  Sampler lane(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return {keys_[at], indices_[at], points_[at]};
  }

  Wide2 pixel() const { return draw2(keys_, points_, 0, 0, 1); }

 private:
  using Words = stdx::rebind_simd_t<std::uint32_t, Wide>;
  using Keys = stdx::rebind_simd_t<std::uint64_t, Wide>;

  static Words reverse(const Words& x) {
    const Words bytes = reverse_bits_of_bytes(x);
    return (bytes >> 24) | ((bytes >> 8) & 0xff00u) | ((bytes << 8) & 0xff0000u) | (bytes << 24);
  }
  /// The low halves.
  static Words words(const Keys& keys) { return stdx::static_simd_cast<Words>(keys); }

  Words shuffled(const Keys& keys) const {
    const Words seeds = words(mix64(keys + 255 * golden64));
    const Words index(indices_.data(), stdx::element_aligned);
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
    const Keys seeds = mix64(keys + (decision + 1) * golden64);
    return {coordinate(points, d0, words(seeds)), coordinate(points, d1, words(seeds >> 32))};
  }

  std::array<std::uint64_t, lanes> places_{};
  std::array<std::uint32_t, lanes> indices_{};
  Keys keys_{std::uint64_t{0}};
  Words points_{0u};
};

}  // namespace rt
