#pragma once
#include <cstdint>
#include <vector>

#include "rt/render/accel/box_group.h"

namespace rt {

/// A few boxes, tested eight at a time: finds the candidates along a ray, as BoxTree does, without
/// building or walking anything. Faster than a hierarchy up to about a hundred boxes
/// (bench/NOTES.md). No candidate is lost (BoxSpace).
class BoxList {
 public:
  explicit BoxList(const std::vector<Bounds>& boxes);

  /// As BoxTree::walk: visit(index) -> new t_max, negative to end. The ray's direction is a unit
  /// vector.
  template <class Visit>
  void walk(const Ray& ray, double t_max, Visit&& visit) const {
    BoxRay p;
    if (!space_.enter(ray, p)) {
      return;
    }
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      alignas(32) float near[BoxGroup::width];
      unsigned hits = groups_[g].touched(p, p.limit(t_max), near);
      while (hits != 0) {
        const int lane = BoxGroup::nearest(hits, near);
        hits &= ~(1U << lane);
        t_max = visit(static_cast<std::uint32_t>(BoxGroup::width * g) +
                      static_cast<std::uint32_t>(lane));
        if (t_max < 0.0) {
          return;
        }
      }
    }
  }

  /// Calls visit(index) -> bool for every box that the shaft may touch, until that is false. False
  /// when the shaft could not be followed.
  template <class Visit>
  bool each_in(const Shaft& shaft, Visit&& visit) const {
    const auto b = space_.enter(shaft);
    for (std::size_t g = 0; b && g < groups_.size(); ++g) {
      for (unsigned hits = groups_[g].touched(*b); hits != 0; hits &= hits - 1) {
        if (!visit(static_cast<std::uint32_t>(BoxGroup::width * g) +
                   static_cast<std::uint32_t>(std::countr_zero(hits)))) {
          return true;
        }
      }
    }
    return b.has_value();
  }

  const BoxSpace& space() const { return space_; }
  const std::vector<BoxGroup>& groups() const { return groups_; }

 private:
  BoxSpace space_;
  std::vector<BoxGroup> groups_;
};

}  // namespace rt
