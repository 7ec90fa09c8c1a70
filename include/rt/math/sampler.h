#pragma once
/// The random decisions of one path: Owen-scrambled points of Sobol's kind (Burley, "Practical
/// hash-based Owen scrambling", JCGT 9(4), 2020), as a pure function of (seed, absolute pixel,
/// sample index, dimension). Threads, tiles, crops and resumed runs therefore draw the same
/// numbers.
///
/// Decisions that interact belong to one integral and are *joint* coordinates of one sequence; were
/// they padded from independent 2D sets, the error of a penumbra as narrow as the pixel would fall
/// as N^-0.51 instead of N^-0.63 (tests/convergence). The table of dimensions:
///
///   decision       vertex 0: joint, Sobol dim.   later vertices: padded, Sobol dim.
///   pixel          0, 1                          -
///   light          2, 3                          0, 1
///   lobe           2, 3, scrambled apart         2, 3
///   time           4                             -
///   lens           5, 7                          -
///   lobe_choice    8                             6
///
/// Light and lobe of one vertex may share dimensions: what they contribute is added, never
/// multiplied, so each is an integral of its own.
///
/// "Later" counts random decisions, not bounces: see Vertex. A padded set visits its own sequence
/// in its own order (an Owen-shuffled index), so it is independent of the joint set and of the
/// other padded sets, while its members are joint with each other.
///
/// Quality: 2^m consecutive points are a (t,m,s)-net in the coordinates listed, that is, every
/// elementary interval of volume 2^(t-m) holds exactly 2^t of them. Scrambling preserves t.
/// Measured (tests/unit/math/sampler_test.cpp) for m = 1..10; 0 is best:
///
///   pixel; light; lobe     0 0 0 0 0 0 0 0 0 0      padded ones too
///   lens                   0 0 0 1 0 1 1 1 2 2
///   pixel, light           0 1 2 1 2 2 3 2 3 3      pixel, lobe; padded light, lobe too
///   pixel, lens            0 1 2 3 4 2 2 3 3 4
///   pixel, time            0 1 1 2 2 1 2 2 2 2
///   pixel, light, time     0 1 2 2 2 3 4 5 3 3
///   lobe, lobe_choice      0 1 1 2 2 3 4 4 3 4
///
/// In base 4, pixel and light are jointly a (0,m,4)-net: at 16, 64, 256, ... samples every box of
/// that many parts with sides that are powers of 4 holds one. The others were chosen, among Joe and
/// Kuo's first 23 dimensions, by smallest sum of t with pixel and with light.
#include <cstdint>

#include "rt/math/hash.h"
#include "rt/math/sobol.h"
#include "rt/math/vec.h"

namespace rt {

/// Where on a path a decision falls.
struct Vertex {
  /// How many random decisions about the path's way (lobe, choice of a lobe, going on) precede this
  /// vertex. The camera's hit is 0, and so is whatever is reached from it by mirrors and both
  /// branches of glass: nothing was drawn on the way, so its light belongs to the joint set.
  std::uint32_t order = 0;
  /// Tells apart decisions of one order whose contributions are *added*: several lights at one
  /// point, the two branches at glass. They share coordinates and differ in scrambling, so each has
  /// its full joint convergence.
  std::uint32_t copy = 0;
};

/// One sample of one pixel. A value of 16 bytes; every draw is const, and costs nothing when it is
/// not made. All numbers lie in the open interval (0,1), on the centres of 2^32 cells.
class Sampler {
 public:
  /// x, y: the pixel's absolute position in the full picture, whatever the crop; may be negative.
  Sampler(std::uint64_t seed, int x, int y, std::uint32_t index)
      : Sampler(combine(seed, place_of(x, y)), index) {}

  /// The same pixel's sample `index`. Any prefix 0..N-1 is good, powers of two are nets.
  Sampler at(std::uint32_t index) const { return Sampler(key_, index); }

  Vec2 pixel() const { return draw2(key_, point_, 0, 0, 1); }
  Vec2 lens() const { return draw2(key_, point_, 1, 5, 7); }
  double time() const { return draw1(key_, point_, 2, 4); }
  /// Position on a light, as a point of the unit square for the warps of warp.h.
  Vec2 light(Vertex v = {}) const { return pair(v, 3, 2, 3, 0, 1); }
  /// Direction within a lobe.
  Vec2 lobe(Vertex v = {}) const { return pair(v, 4, 2, 3, 2, 3); }
  /// Which lobe; reflection or refraction; go on or stop.
  double lobe_choice(Vertex v = {}) const { return single(v, 6, 8, 6); }

 private:
  friend class WideSampler;

  Sampler(std::uint64_t key, std::uint32_t index, std::uint32_t point)
      : key_(key), index_(index), point_(point) {}
  Sampler(std::uint64_t key, std::uint32_t index)
      : key_(key), index_(index), point_(shuffled(index, key)) {}

  static std::uint64_t place_of(int x, int y) {
    return (std::uint64_t{static_cast<std::uint32_t>(x)} << 32) | static_cast<std::uint32_t>(y);
  }

  /// A permutation of the index that maps aligned blocks of 2^m to aligned blocks: an Owen
  /// scrambling of its low 16 bits. Bits above only shift a block's points digitally, which the
  /// scrambling of the points does anyway.
  static std::uint32_t shuffled(std::uint32_t index, std::uint64_t key) {
    const auto seed = static_cast<std::uint32_t>(mix64(key + 255 * golden64));
    const std::uint32_t low = reverse_bits(owen_reversed(reverse_bits(index << 16), seed)) >> 16;
    return (index & 0xffff0000u) | low;
  }

  static double coordinate(std::uint32_t point, int dimension, std::uint32_t seed) {
    return unit_interval(reverse_bits(owen_reversed(sobol_reversed(point, dimension), seed)));
  }
  static double draw1(std::uint64_t key, std::uint32_t point, std::uint64_t decision, int d) {
    return coordinate(point, d, static_cast<std::uint32_t>(mix64(key + (decision + 1) * golden64)));
  }
  static Vec2 draw2(std::uint64_t key, std::uint32_t point, std::uint64_t decision, int d0,
                    int d1) {
    const std::uint64_t seeds = mix64(key + (decision + 1) * golden64);
    return {coordinate(point, d0, static_cast<std::uint32_t>(seeds)),
            coordinate(point, d1, static_cast<std::uint32_t>(seeds >> 32))};
  }

  std::uint64_t key(Vertex v) const {
    return (v.order | v.copy) == 0 ? key_ : combine(key_, (std::uint64_t{v.order} << 32) | v.copy);
  }
  /// The point of a padded set: copies share it, orders do not.
  std::uint32_t padded_point(Vertex v) const {
    return shuffled(index_, combine(key_, std::uint64_t{v.order} << 32));
  }
  Vec2 pair(Vertex v, std::uint64_t decision, int d0, int d1, int padded0, int padded1) const {
    return v.order == 0 ? draw2(key(v), point_, decision, d0, d1)
                        : draw2(key(v), padded_point(v), decision, padded0, padded1);
  }
  double single(Vertex v, std::uint64_t decision, int d, int padded) const {
    return v.order == 0 ? draw1(key(v), point_, decision, d)
                        : draw1(key(v), padded_point(v), decision, padded);
  }

  std::uint64_t key_;    ///< of seed and pixel
  std::uint32_t index_;  ///< as given
  std::uint32_t point_;  ///< of the joint set
};

}  // namespace rt
