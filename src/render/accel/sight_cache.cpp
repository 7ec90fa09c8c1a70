#include "rt/render/accel/sight_cache.h"

#include <cmath>

#include "rt/render/accel/box_list.h"
#include "rt/render/accel/box_tree.h"

namespace rt {
namespace {

/// The pyramid from the eye through a block, as far as the boxes reach.
Shaft pyramid(const RenderPlan& plan, int x, int y, double reach) {
  constexpr double block = SightCache::block;
  const RenderOptions& o = plan.options;
  Shaft shaft{{Vec3(0.0), Vec3(0.0)}, {}};
  for (const int i : {0, 1}) {
    for (const int j : {0, 1}) {
      shaft.to.extend(reach *
                      plan.camera.direction(block * (x + i) / o.width, block * (y + j) / o.height));
    }
  }
  return shaft;
}

}  // namespace

SightCache::SightCache(const RenderPlan& plan) : plan_(plan) {
  if ((plan.list || plan.tree) && !plan.moving_camera && plan.camera.lens_radius == 0.0) {
    table_.resize(entries);
  }
}

void SightCache::fill(Entry& entry) const {
  const auto add = [&](std::uint32_t instance) {
    entry.few = entry.count < most;
    if (entry.few) {
      entry.instances[entry.count++] = instance;
    }
    return entry.few;
  };
  entry.filled = true;
  entry.few = true;
  entry.count = 0;
  for (const std::uint32_t id : plan_.unbounded()) {
    if (!add(id)) {
      return;
    }
  }
  const auto look = [&](const auto& boxes) {
    const Shaft shaft = pyramid(plan_, entry.x, entry.y, boxes.space().far_end());
    return boxes.each_in(shaft, add);
  };
  if (!(plan_.list ? look(*plan_.list) : look(*plan_.tree))) {
    entry.few = false;
  }
}

Candidates SightCache::through(double x, double y) {
  if (table_.empty()) {
    return {};
  }
  const int i = static_cast<int>(std::floor(x / (1.0 * block)));
  const int j = static_cast<int>(std::floor(y / (1.0 * block)));
  // Sixteen blocks by sixteen: a tile's, and more.
  Entry& entry = table_[static_cast<unsigned>(i) % 16U + 16U * (static_cast<unsigned>(j) % 16U)];
  if (!entry.filled || entry.x != i || entry.y != j) {
    entry.x = i;
    entry.y = j;
    fill(entry);
  }
  return {entry.few, false, {entry.instances.data(), entry.count}};
}

}  // namespace rt
