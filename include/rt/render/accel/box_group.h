#pragma once
/// Boxes in single precision, tested eight at a time against rays and shafts: what BoxList and
/// BoxTree are made of.
#include <immintrin.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
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
    const auto far = static_cast<float>(t_max * per_t - entry);
    return far + std::abs(far) * 0x1p-20F + 0x1p-17F;
  }
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
  alignas(32) float lo[3][width];
  alignas(32) float hi[3][width];

  /// Bit i: the ray may touch box i before `limit`; near[i]: where it enters.
  unsigned touched(const BoxRay& ray, float limit, float* near) const {
    __m256 enter = _mm256_setzero_ps();
    __m256 leave = _mm256_set1_ps(limit);
    for (std::size_t k = 0; k < 3; ++k) {
      const __m256 o = _mm256_set1_ps(ray.origin[k]);
      const __m256 inverse = _mm256_set1_ps(ray.inverse[k]);
      const __m256 a = _mm256_mul_ps(_mm256_sub_ps(_mm256_load_ps(lo[k]), o), inverse);
      const __m256 b = _mm256_mul_ps(_mm256_sub_ps(_mm256_load_ps(hi[k]), o), inverse);
      enter = _mm256_max_ps(enter, _mm256_min_ps(a, b));
      leave = _mm256_min_ps(leave, _mm256_max_ps(a, b));
    }
    _mm256_store_ps(near, enter);
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(enter, leave, _CMP_LE_OQ)));
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

  /// False when the ray passes all boxes by. Its direction is a unit vector, or of that length.
  bool enter(const Ray& ray, BoxRay& to) const;
  bool enter(const Ray& ray, double length, BoxRay& to) const;
  /// A distance from where shafts may begin to beyond all boxes.
  double far_end() const { return 2.0 * shaft_reach / per_unit_; }
  /// None when the shaft begins too far away to be told from others.
  std::optional<BoxShaft> enter(const Shaft& shaft) const;

 private:
  /// Shafts begin no further than this from the boxes' centre, in half-edges of their cube.
  static constexpr double shaft_reach = 8.0;

  Vec3 centre_{0.0};
  double per_unit_ = 1.0;  ///< 1 / half the edge of the cube about all boxes
};

}  // namespace rt
