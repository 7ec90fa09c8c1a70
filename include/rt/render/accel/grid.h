#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "rt/math/bounds.h"
#include "rt/math/ray.h"

namespace rt {

/// A uniform grid over boxes, walked cell by cell: Amanatides and Woo, "A fast voxel traversal
/// algorithm for ray tracing", Eurographics 1987. It is built in a moment and is good where things
/// are spread evenly; where they crowd in a corner all of them share a few cells, and a hierarchy
/// is hundreds of times faster (bench/NOTES.md).
///
/// In double precision. No candidate is lost: boxes are entered into all cells within `slack` of
/// them, which is more than rounding can move a ray. Holds for boxes that are finite and not empty.
class Grid {
 public:
  explicit Grid(const std::vector<Bounds>& boxes);
  /// What it takes.
  std::size_t bytes() const { return (begins_.size() + boxes_.size()) * sizeof(std::uint32_t); }

  /// As BoxTree::walk. A box that spans several cells is visited in each, unless it was the last
  /// one visited.
  template <class Visit>
  void walk(const Ray& ray, double t_max, Visit&& visit) const {
    Steps at;
    if (!enter(ray, at)) {
      return;
    }
    std::uint32_t last = none;
    for (;;) {
      const std::size_t cell = index(at.cell);
      for (std::uint32_t i = begins_[cell]; i < begins_[cell + 1]; ++i) {
        if (boxes_[i] != last) {
          last = boxes_[i];
          t_max = visit(last);
          if (t_max < 0.0) {
            return;
          }
        }
      }
      if (!at.advance(t_max, counts_)) {
        return;
      }
    }
  }

 private:
  static constexpr std::uint32_t none = ~0U;
  /// Of a cell's edge: boxes are taken for so much larger. A ray's place in cells carries the
  /// rounding of at most 2^10 cells' coordinates, and of its origin, up to 2^20 cells away.
  static constexpr double slack = 0x1p-20;

  /// Where a ray is: the cell, and where it crosses into the next along each axis.
  struct Steps {
    std::array<int, 3> cell, step;
    std::array<double, 3> next, per_cell;

    /// On to the next cell; false at the grid's end, or when that lies beyond t_max.
    bool advance(double t_max, const std::array<int, 3>& counts) {
      const std::size_t k =
          next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
      // A crossing just before the cell's end may belong to a box entered there.
      if (next[k] > t_max + slack * per_cell[k]) {
        return false;
      }
      cell[k] += step[k];
      next[k] += per_cell[k];
      return cell[k] >= 0 && cell[k] < counts[k];
    }
  };

  bool enter(const Ray& ray, Steps& at) const;
  std::size_t index(const std::array<int, 3>& cell) const {
    return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(counts_[1]) +
            static_cast<std::size_t>(cell[1])) *
               static_cast<std::size_t>(counts_[0]) +
           static_cast<std::size_t>(cell[0]);
  }
  double entries(const std::vector<Bounds>& boxes) const;
  /// The range of cells that a box is entered into.
  std::pair<std::array<int, 3>, std::array<int, 3>> cells_of(const Bounds& box) const;

  Vec3 corner_{0.0};
  Vec3 per_unit_{1.0};  ///< cells per unit of length
  std::array<int, 3> counts_{1, 1, 1};
  std::vector<std::uint32_t> begins_;  ///< of each cell's boxes in boxes_; one more at the end
  std::vector<std::uint32_t> boxes_;
};

}  // namespace rt
