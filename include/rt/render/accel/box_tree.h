#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "rt/math/bounds.h"
#include "rt/math/ray.h"

namespace rt {

/// A hierarchy over boxes that finds the candidates along a ray; which of them is hit, and where,
/// the caller decides in double precision.
///
/// Embree walks it, in single precision. It cannot lose a candidate: boxes and rays are moved and
/// scaled in double so that all boxes fill [-1,1]^3, rays are clipped to that cube and given an
/// origin on or in it, and the boxes are enlarged by more than rays and boxes can be displaced by
/// rounding (see box_tree.cpp). Holds for boxes that are finite and not empty.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Bounds>& boxes);
  ~BoxTree();
  BoxTree(const BoxTree&) = delete;
  BoxTree& operator=(const BoxTree&) = delete;

  /// Calls visit(index) -> double for every box whose part 0 <= t <= t_max the ray may touch,
  /// nearer ones mostly first. What it returns is the new t_max; a negative one ends the walk.
  template <class Visit>
  void walk(const Ray& ray, double t_max, Visit&& visit) const {
    walk_candidates(ray, t_max, &visit, [](void* context, std::uint32_t index) {
      return (*static_cast<std::remove_reference_t<Visit>*>(context))(index);
    });
  }

 private:
  using VisitFunction = double (*)(void*, std::uint32_t);
  void walk_candidates(const Ray& ray, double t_max, void* context, VisitFunction visit) const;

  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rt
