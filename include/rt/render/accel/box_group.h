#pragma once
/// Boxes in single precision, tested eight at a time against rays and shafts: what BoxList and
/// BoxTree are made of.
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <experimental/simd>
#include <optional>
#include <vector>

#include "rt/math/bounds.h"
#include "rt/math/ray.h"

namespace rt {

/// A ray in the space of the boxes, which are moved and scaled to fill [-1,1]^3.
struct BoxRay {
  std::array<float, 3> origin;
  std::array<float, 3> inverse;  ///< of the direction, finite
  double per_t = 1.0;            ///< float parameter = t per_t - entry
  double entry = 0.0;

  /// The float parameter for a limit in t, increased by more than float arithmetic can err.
  float limit(double t_max) const {
    return beyond_rounding(static_cast<float>(t_max * per_t - entry));
  }
  static float beyond_rounding(float far) { return far + std::abs(far) * 0x1p-20F + 0x1p-17F; }
};

/// All segments from the points of one box to those of another: a shaft after Haines and Wallace,
/// "Shaft culling for efficient ray-cast radiosity", 1991.
struct Shaft {
  Bounds from;
  Bounds to;
};

/// A shaft in the space of the boxes: at s in [0,1] its section lies within centre + s travel +-
/// (half + s growth).
struct BoxShaft {
  std::array<float, 3> centre, travel, half, growth;
};

/// Eight boxes: lower and upper faces of each axis.
struct BoxGroup {
  static constexpr std::size_t width = 8;
  /// Eight floats: one register, or two where registers are smaller.
  using Floats =
      std::experimental::simd<float, std::experimental::simd_abi::deduce_t<float, width>>;

  alignas(32) float lo[3][width];
  alignas(32) float hi[3][width];

  static Floats load(const float* eight) { return {eight, std::experimental::vector_aligned}; }
  static unsigned bits_of(const Floats::mask_type& m) {
    return static_cast<unsigned>(m.__to_bitset().to_ulong());
  }

  /// Bit i: the ray may touch box i before `limit`; near: where it enters.
  unsigned touched(const BoxRay& ray, float limit, Floats& near) const {
    Floats enter = 0.0F;
    Floats leave = limit;
    for (std::size_t k = 0; k < 3; ++k) {
      const Floats a = (load(lo[k]) - ray.origin[k]) * ray.inverse[k];
      const Floats b = (load(hi[k]) - ray.origin[k]) * ray.inverse[k];
      enter = max(enter, min(a, b));
      leave = min(leave, max(a, b));
    }
    near = enter;
    return bits_of(enter <= leave);
  }
  unsigned touched(const BoxRay& ray, float limit, float* near) const {
    Floats enter;
    const unsigned hits = touched(ray, limit, enter);
    enter.copy_to(near, std::experimental::vector_aligned);
    return hits;
  }

  /// Bit i: some segment of the shaft may touch box i.
  unsigned touched(const BoxShaft& shaft) const;

  /// Which of the boxes in `hits`, not 0, is entered first.
  static int nearest(unsigned hits, const float* near) {
    int best = std::countr_zero(hits);
    for (unsigned rest = hits & (hits - 1); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      best = near[lane] < near[best] ? lane : best;
    }
    return best;
  }
};

/// What holds all boxes.
Bounds all_of(const std::vector<Bounds>& boxes);

/// The map into [-1,1]^3, and what keeps float tests there from losing a box: rays and shafts are
/// moved and scaled in double, those from further off start where they reach that cube, and boxes
/// are enlarged by more than rounding can displace them (box_group.cpp). Holds for boxes that are
/// finite.
class BoxSpace {
 public:
  BoxSpace() = default;
  /// For boxes that `all` holds.
  explicit BoxSpace(const Bounds& all);
  explicit BoxSpace(const std::vector<Bounds>& boxes);

  struct Box {
    std::array<float, 3> lo, hi;
  };
  /// Enlarged.
  Box box(const Bounds& bounds) const;
  /// One that nothing touches.
  static Box nothing();
  static void put(BoxGroup& group, std::size_t lane, const Box& box);
  /// Bit i: box i is not nothing.
  static unsigned filled(const BoxGroup& group);

  /// False when the ray passes all boxes by. Its direction is a unit vector, or of that length.
  bool enter(const Ray& ray, BoxRay& to) const;
  bool enter(const Ray& ray, double length, BoxRay& to) const;
  /// A distance from where shafts may begin to beyond all boxes.
  double far_end() const { return 2.0 * shaft_reach / per_unit_; }
  /// None when the shaft begins too far away to be told from others.
  std::optional<BoxShaft> enter(const Shaft& shaft) const;

  const Vec3& centre() const { return centre_; }
  double per_unit() const { return per_unit_; }
  /// Rays that begin nearer than this to the centre, in half-edges of the cube, need not be
  /// clipped.
  static constexpr double reach_of_rays = 8.0;
  /// Stands for 1/0: no path is so long.
  static constexpr double endless = 1e30;

 private:
  /// Shafts begin no further than this from the boxes' centre, in half-edges of their cube.
  static constexpr double shaft_reach = 8.0;

  Vec3 centre_{0.0};
  double per_unit_ = 1.0;  ///< 1 / half the edge of the cube about all boxes
};

}  // namespace rt
