#include "rt/render/accel/shadow_cache.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "rt/math/rounding.h"
#include "rt/render/accel/box_list.h"
#include "rt/render/accel/box_tree.h"

namespace rt {
namespace {

/// Edge of a cell in pixels, as seen from the eye (bench/NOTES.md).
constexpr double cell_pixels = 16.0;
/// A cell's three indices take 12 bits each of its key.
constexpr int index_bits = 12;
constexpr int finest = index_bits - 2;

int fineness_of(const RenderPlan& plan) {
  const double pixel = 2.0 * glm::length(plan.camera.down) / plan.options.height;
  return std::clamp(static_cast<int>(std::round(-std::log2(pixel * cell_pixels))), 1, finest);
}

/// All the places of a light.
Bounds box_of(const Light& light) {
  Vec3 half(light.radius);
  if (light.rectangle) {
    half = 0.5 * (glm::abs(light.rectangle->u) + glm::abs(light.rectangle->v));
  }
  Bounds box{light.position - half, light.position + half};
  box.extend({box.lo + light.travel, box.hi + light.travel});
  return box;
}

/// The range of a plane's model y over a box, widened by its rounding.
std::pair<double, double> heights(const Affine& model_from_render, const Bounds& box) {
  const Mat3& m = model_from_render.linear;
  const Vec3 up(m[0].y, m[1].y, m[2].y);
  const double centre = glm::dot(up, box.centre()) + model_from_render.offset.y;
  const double size = glm::dot(glm::abs(up), glm::max(glm::abs(box.lo), glm::abs(box.hi)));
  const double reach = 0.5 * glm::dot(glm::abs(up), box.extent()) +
                       gamma(16) * (size + std::abs(model_from_render.offset.y));
  return {centre - reach, centre + reach};
}

bool holds(const Bounds& cell, const Vec3& p) {
  return p.x >= cell.lo.x && p.x < cell.hi.x && p.y >= cell.lo.y && p.y < cell.hi.y &&
         p.z >= cell.lo.z && p.z < cell.hi.z;
}

/// Whether a plane may cross the shaft.
bool crosses(const RenderPlan& plan, const PlannedInstance& plane, const Shaft& shaft) {
  if (plane.moves() || !plane.is<Plane>()) {
    return true;
  }
  const Affine model_from_render = plan.placement(plane).model_from_render;
  const auto [a, b] = heights(model_from_render, shaft.from);
  const auto [c, d] = heights(model_from_render, shaft.to);
  return !(std::min(a, c) > 0.0 || std::max(b, d) < 0.0);
}

}  // namespace

ShadowCache::ShadowCache(const RenderPlan& plan) : plan_(plan), fineness_(fineness_of(plan)) {
  for (const PlannedLight& light : plan.lights) {
    lights_.push_back(box_of(light));
  }
  last_.resize(lights_.size());
  if (plan.list || plan.tree || plan.shaft_list || plan.bounded.empty()) {
    table_.resize(entries);
  }
}

ShadowCache::Cell ShadowCache::cell_of(std::size_t light, const Vec3& position) const {
  constexpr std::uint64_t far = 2046;
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(max_abs(position)) >> 52U;
  if (light >= 0xffff || exponent < 64 || exponent > far - 64) {
    return {};
  }
  const auto fineness = static_cast<std::uint64_t>(fineness_);
  const auto scale = std::bit_cast<double>((far - exponent + fineness) << 52U);
  const auto edge = std::bit_cast<double>((exponent - fineness) << 52U);  // exactly its inverse
  const Vec3 index = glm::floor(position * scale);
  Cell cell;
  cell.key = 1U + light;
  cell.key = cell.key << 11U | exponent;
  for (int k = 0; k < 3; ++k) {
    const auto place = static_cast<std::int64_t>(index[k]) + (1 << (index_bits - 1));
    cell.key = cell.key << index_bits | static_cast<std::uint64_t>(place);
  }
  cell.bounds = {index * edge, (index + 1.0) * edge};
  return cell;
}

bool ShadowCache::add(Entry& entry, std::uint32_t instance) const {
  const Shadow shadow = plan_.instances[instance].shadow;
  if (shadow == Shadow::none) {
    return true;
  }
  if (entry.count == most) {
    entry.state = State::many;
    return false;
  }
  entry.dims = entry.dims || shadow == Shadow::dims;
  entry.instances[entry.count++] = instance;
  return true;
}

void ShadowCache::fill(Entry& entry, const Bounds& cell, std::size_t light) const {
  const Shaft shaft{cell, lights_[light]};
  entry.state = State::known;
  for (const std::uint32_t id : plan_.unbounded) {
    if (crosses(plan_, plan_.instances[id], shaft) && !add(entry, id)) {
      return;
    }
  }
  const auto add_box = [&](std::uint32_t index) { return add(entry, plan_.bounded[index]); };
  // Shafts from afar are not followed; then it is the light that is near.
  const auto each_in = [&](const auto& boxes) {
    return boxes.each_in(shaft, add_box) || boxes.each_in({shaft.to, shaft.from}, add_box);
  };
  const BoxList* list = plan_.list ? plan_.list.get() : plan_.shaft_list.get();
  if (list == nullptr && !plan_.tree) {
    return;  // there are no boxes
  }
  if (!(list != nullptr ? each_in(*list) : each_in(*plan_.tree))) {
    entry.state = State::many;
  }
}

Candidates ShadowCache::towards(std::size_t light, const Vec3& position, bool at_once,
                                Bounds* cell_bounds) {
  if (table_.empty()) {
    return {};
  }
  Last& last = last_[light];
  if (last.entry == nullptr || last.entry->key != last.cell.key ||
      !holds(last.cell.bounds, position)) {
    last = {cell_of(light, position), nullptr};
    if (last.cell.key == 0) {
      return {};
    }
    // Fibonacci hashing (Knuth, TAOCP 3, 6.4): the upper bits of a product with 2^64 / phi.
    Entry& entry = table_[(last.cell.key * 0x9e3779b97f4a7c15U) >> 54U];
    const bool asked = entry.key == last.cell.key;
    if (!asked) {
      entry = {};
      entry.key = last.cell.key;
    }
    if (asked || at_once) {
      if (entry.state == State::unknown) {
        fill(entry, last.cell.bounds, light);
      }
      last.entry = &entry;
    }
  }
  if (cell_bounds != nullptr) {
    *cell_bounds = last.cell.bounds;
  }
  return last.entry != nullptr ? answer(*last.entry) : Candidates{};
}

}  // namespace rt
