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
constexpr std::int64_t middle = 1 << (index_bits - 1);
constexpr int finest = index_bits - 2;
/// Then come 11 bits of an exponent, such that neither an edge nor its inverse is beyond a double.
constexpr int cell_bits = 3 * index_bits + 11;
constexpr std::uint64_t least_exponent = 64;
constexpr std::uint64_t most_exponent = 2046 - 64;
constexpr std::size_t most_light = (1U << (64 - cell_bits)) - 1U;

/// A positive double's exponent as it is stored, and the power of two that has it.
std::uint64_t exponent_of(double v) { return std::bit_cast<std::uint64_t>(v) >> 52U; }
double with_exponent(std::uint64_t exponent) { return std::bit_cast<double>(exponent << 52U); }

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
  last_blockers_.resize(lights_.size(), no_instance);
  if (plan.list || plan.tree || plan.shaft_list || plan.bounded == 0) {
    table_.resize(entries);
    instances_.resize(entries);
  }
}

ShadowCache::Cell ShadowCache::cell_of(const Vec3& position) const {
  const std::uint64_t exponent = exponent_of(max_abs(position));
  if (exponent < least_exponent || exponent > most_exponent) {
    return nowhere;
  }
  const auto scale = with_exponent(2046 - exponent + static_cast<std::uint64_t>(fineness_));
  Cell cell = exponent;
  for (int k = 0; k < 3; ++k) {
    const auto place = static_cast<std::int64_t>(std::floor(position[k] * scale)) + middle;
    cell = cell << index_bits | static_cast<std::uint64_t>(place);
  }
  return cell;
}

Wide ShadowCache::cells_of(const Wide3& positions) const {
  using Words = stdx::rebind_simd_t<std::uint64_t, Wide>;
  const Words exponents = std::bit_cast<Words>(max_abs(positions)) >> 52;
  const Wide exponent = stdx::static_simd_cast<Wide>(exponents);
  const Wide scale =
      std::bit_cast<Wide>((Words(2046 + static_cast<std::uint64_t>(fineness_)) - exponents) << 52);
  const auto append = [&](const Wide& cell, const Wide& position) {
    return cell * (2.0 * middle) + (stdx::floor(position * scale) + 1.0 * middle);
  };
  const Wide cell = append(append(append(exponent, positions.x), positions.y), positions.z);
  return select(exponent >= 1.0 * least_exponent && exponent <= 1.0 * most_exponent, cell,
                Wide(1.0 * nowhere));
}

Bounds ShadowCache::bounds_of(Cell cell) const {
  const double edge =
      with_exponent((cell >> (3 * index_bits)) - static_cast<std::uint64_t>(fineness_));
  Vec3 place;
  for (int k = 2; k >= 0; --k) {
    place[k] = static_cast<double>(static_cast<std::int64_t>(cell & (2 * middle - 1)) - middle);
    cell >>= index_bits;
  }
  return {place * edge, (place + 1.0) * edge};
}

bool ShadowCache::add(Entry& entry, std::uint32_t instance) {
  const Shadow shadow = plan_.instances[instance].shadow;
  if (shadow == Shadow::none) {
    return true;
  }
  if (entry.count == most) {
    entry.state = State::many;
    return false;
  }
  entry.dims = entry.dims || shadow == Shadow::dims;
  instances_[place(entry)][entry.count++] = instance;
  return true;
}

void ShadowCache::fill(Entry& entry, Cell cell, std::size_t light) {
  const Shaft shaft{bounds_of(cell), lights_[light]};
  entry.state = State::known;
  for (const std::uint32_t id : plan_.unbounded()) {
    if (crosses(plan_, plan_.instances[id], shaft) && !add(entry, id)) {
      return;
    }
  }
  const auto add_box = [&](std::uint32_t id) { return add(entry, id); };
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

Candidates ShadowCache::towards(std::size_t light, Cell cell, bool at_once) {
  if (table_.empty() || cell == nowhere || light > most_light) {
    return {};
  }
  const std::uint64_t key = light << cell_bits | cell;
  Last& last = last_[light];
  if (last.entry == nullptr || last.key != key || last.entry->key != key) {
    last = {key, nullptr};
    // Fibonacci hashing (Knuth, TAOCP 3, 6.4): the upper bits of a product with 2^64 / phi.
    Entry& entry = table_[(key * 0x9e3779b97f4a7c15U) >> 54U];
    const bool asked = entry.key == key;
    if (!asked) {
      entry = {};
      entry.key = key;
    }
    if (asked || at_once) {
      if (entry.state == State::unknown) {
        fill(entry, cell, light);
      }
      last.entry = &entry;
    }
  }
  return last.entry != nullptr ? answer(*last.entry) : Candidates{};
}

}  // namespace rt
