#pragma once
#include <immintrin.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "rt/math/bounds.h"
#include "rt/math/ray.h"

namespace rt {

/// A few boxes, tested eight at a time: finds the candidates along a ray, as BoxTree does, without
/// building or walking anything. Faster than a hierarchy up to about a hundred boxes
/// (bench/NOTES.md).
///
/// In single precision, yet no candidate is lost: all boxes are moved and scaled in double to fill
/// [-1,1]^3, rays from further off start where they reach that cube, and boxes are enlarged by more
/// than rounding can displace them (box_list.cpp).
class BoxList {
 public:
  explicit BoxList(const std::vector<Bounds>& boxes);

  /// As BoxTree::walk: visit(index) -> new t_max, negative to end. The ray's direction is a unit
  /// vector.
  template <class Visit>
  void walk(const Ray& ray, double t_max, Visit&& visit) const {
    Prepared p;
    if (!prepare(ray, p)) {
      return;
    }
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      alignas(32) float near[width];
      unsigned hits = touched(groups_[g], p, static_cast<float>(t_max * p.per_t - p.entry), near);
      while (hits != 0) {
        const int lane = nearest(hits, near);
        hits &= ~(1U << lane);
        t_max = visit(static_cast<std::uint32_t>(width * g) + static_cast<std::uint32_t>(lane));
        if (t_max < 0.0) {
          return;
        }
      }
    }
  }

 private:
  static constexpr int width = 8;
  /// Eight boxes: lower and upper faces of each axis.
  struct Group {
    alignas(32) float lo[3][width];
    alignas(32) float hi[3][width];
  };
  struct Prepared {
    std::array<float, 3> origin;
    std::array<float, 3> inverse;  ///< of the direction, finite
    double per_t = 1.0;            ///< float parameter = t per_t - entry
    double entry = 0.0;
  };

  bool prepare(const Ray& ray, Prepared& p) const;

  /// Bit i: the ray may touch box i of the group before `far`; near[i]: where it enters.
  static unsigned touched(const Group& group, const Prepared& p, float far, float* near) {
    __m256 enter = _mm256_setzero_ps();
    __m256 leave = _mm256_set1_ps(far + std::abs(far) * 0x1p-20F + 0x1p-17F);
    for (std::size_t k = 0; k < 3; ++k) {
      const __m256 o = _mm256_set1_ps(p.origin[k]);
      const __m256 inverse = _mm256_set1_ps(p.inverse[k]);
      const __m256 a = _mm256_mul_ps(_mm256_sub_ps(_mm256_load_ps(group.lo[k]), o), inverse);
      const __m256 b = _mm256_mul_ps(_mm256_sub_ps(_mm256_load_ps(group.hi[k]), o), inverse);
      enter = _mm256_max_ps(enter, _mm256_min_ps(a, b));
      leave = _mm256_min_ps(leave, _mm256_max_ps(a, b));
    }
    _mm256_store_ps(near, enter);
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(enter, leave, _CMP_LE_OQ)));
  }

  static int nearest(unsigned hits, const float* near) {
    int best = std::countr_zero(hits);
    for (unsigned rest = hits & (hits - 1); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      best = near[lane] < near[best] ? lane : best;
    }
    return best;
  }

  Vec3 centre_{0.0};
  double per_unit_ = 1.0;  ///< 1 / half the edge of the cube about all boxes
  std::vector<Group> groups_;
};

}  // namespace rt
