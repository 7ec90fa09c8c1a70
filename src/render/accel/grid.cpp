#include "rt/render/accel/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rt/render/accel/box_group.h"

namespace rt {
namespace {

/// Cells a box: between 2 and 5 the time changes little (bench/NOTES.md).
constexpr double cells_per_box = 3.0;
/// In so many cells a box may stand, in the mean: 256 bytes.
constexpr double most_entries_per_box = 64.0;
constexpr int most_cells = 1 << 10;  ///< along an axis
constexpr double inf = std::numeric_limits<double>::infinity();

}  // namespace

Grid::Grid(const std::vector<Bounds>& boxes) {
  const Bounds all = all_of(boxes);
  // As near to cubes as whole numbers allow; along an axis without extent one cell, of any size.
  const double largest =
      boxes.empty() || !(max_abs(all.extent()) > 0.0) ? 1.0 : max_abs(all.extent());
  const Vec3 extent = glm::max(boxes.empty() ? Vec3(1.0) : all.extent(), Vec3(1e-3 * largest));
  corner_ = boxes.empty() ? Vec3(0.0) : all.centre() - 0.5 * extent;
  const auto divide = [&](double cells) {
    const double edge =
        std::cbrt(extent.x / largest * extent.y / largest * extent.z / largest / cells) * largest;
    for (int k = 0; k < 3; ++k) {
      const double count = std::clamp(std::round(extent[k] / edge), 1.0, double{most_cells});
      counts_[static_cast<std::size_t>(k)] = static_cast<int>(count);
      per_unit_[k] = count / extent[k];
    }
  };
  // Coarser where boxes overlap so much that each would stand in many cells.
  const auto number = static_cast<double>(std::max<std::size_t>(1, boxes.size()));
  double cells = cells_per_box * number;
  for (divide(cells); entries(boxes) > most_entries_per_box * number && cells > 1.0;) {
    cells /= 8.0;
    divide(cells);
  }
  // Two passes: how many boxes each cell has, then which.
  begins_.assign(index({counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}) + 2, 0);
  const auto each_cell = [&](const Bounds& box, auto&& visit) {
    const auto [lo, hi] = cells_of(box);
    for (int z = lo[2]; z <= hi[2]; ++z) {
      for (int y = lo[1]; y <= hi[1]; ++y) {
        for (int x = lo[0]; x <= hi[0]; ++x) {
          visit(index({x, y, z}));
        }
      }
    }
  };
  for (const Bounds& box : boxes) {
    each_cell(box, [&](std::size_t cell) { ++begins_[cell + 1]; });
  }
  for (std::size_t i = 1; i < begins_.size(); ++i) {
    begins_[i] += begins_[i - 1];
  }
  boxes_.resize(begins_.back());
  std::vector<std::uint32_t> filled(begins_.begin(), begins_.end() - 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    each_cell(boxes[i], [&](std::size_t cell) { boxes_[filled[cell]++] = i; });
  }
}

/// In how many cells boxes stand, all together.
double Grid::entries(const std::vector<Bounds>& boxes) const {
  double sum = 0.0;
  for (const Bounds& box : boxes) {
    const auto [lo, hi] = cells_of(box);
    sum += (hi[0] - lo[0] + 1.0) * (hi[1] - lo[1] + 1.0) * (hi[2] - lo[2] + 1.0);
  }
  return sum;
}

std::pair<std::array<int, 3>, std::array<int, 3>> Grid::cells_of(const Bounds& box) const {
  const Vec3 from = (box.lo - corner_) * per_unit_ - slack;
  const Vec3 to = (box.hi - corner_) * per_unit_ + slack;
  std::pair<std::array<int, 3>, std::array<int, 3>> cells;
  for (std::size_t k = 0; k < 3; ++k) {
    const double end = counts_[k] - 1;
    const int axis = static_cast<int>(k);
    cells.first[k] = static_cast<int>(std::clamp(std::floor(from[axis]), 0.0, end));
    cells.second[k] = static_cast<int>(std::clamp(std::floor(to[axis]), 0.0, end));
  }
  return cells;
}

bool Grid::enter(const Ray& ray, Steps& at) const {
  const Vec3 origin = (ray.origin - corner_) * per_unit_;
  const Vec3 direction = ray.direction * per_unit_;
  double first = 0.0;
  double last = inf;
  for (int k = 0; k < 3; ++k) {
    const double count = counts_[static_cast<std::size_t>(k)];
    if (direction[k] == 0.0) {
      if (!(origin[k] >= -slack && origin[k] <= count + slack)) {
        return false;
      }
      continue;
    }
    const double a = (-slack - origin[k]) / direction[k];
    const double b = (count + slack - origin[k]) / direction[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first <= last && last < inf)) {
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    const double place = origin[axis] + first * direction[axis];
    const double cell = std::clamp(std::floor(place), 0.0, double{counts_[k] - 1.0});
    at.cell[k] = static_cast<int>(cell);
    at.step[k] = direction[axis] > 0.0 ? 1 : -1;
    at.per_cell[k] = direction[axis] != 0.0 ? std::abs(1.0 / direction[axis]) : inf;
    at.next[k] = direction[axis] != 0.0
                     ? (cell + (direction[axis] > 0.0 ? 1.0 : 0.0) - origin[axis]) / direction[axis]
                     : inf;
  }
  return true;
}

}  // namespace rt
