#include "rt/render/pixel.h"

#include <cmath>

namespace rt {
namespace {

/// Where in its pixel sample `index` of `count` lies. Samples fill a grid of near-square cells,
/// each at its cell's centre; the grid's last row is stretched over what is left.
Vec2 regular_position(int index, int count) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  const int rows = (count + columns - 1) / columns;
  const int row = index / columns;
  const int in_row = row == rows - 1 ? count - row * columns : columns;
  return {(index % columns + 0.5) / in_row, (row + 0.5) / rows};
}

}  // namespace

Rgb render_pixel(const RenderPlan& plan, int x, int y, RenderStatistics& statistics) {
  const RenderOptions& options = plan.options;
  const int count = options.antialiasing ? options.samples : 1;
  Rgb sum(0.0);
  int good = 0;
  for (int i = 0; i < count; ++i) {
    const Vec2 offset = regular_position(i, count);
    const double px = (x + offset.x) / options.width;
    const double py = (y + offset.y) / options.height;
    const TraceRay ray{Vec3(0.0), plan.camera.direction(px, py)};
    const Rgb value = radiance(plan, ray, py, statistics.rays);
    if (all_finite(value)) {
      sum += value;
      ++good;
    } else if (statistics.bad_samples++ == 0) {
      statistics.first_bad_x = x;
      statistics.first_bad_y = y;
    }
  }
  statistics.samples += static_cast<std::uint64_t>(count);
  return good > 0 ? sum / static_cast<double>(good) : Rgb(0.0);
}

}  // namespace rt
