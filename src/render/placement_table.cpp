#include "rt/render/placement_table.h"

#include <bit>

#include "rt/math/hash.h"

namespace rt {
namespace {

constexpr std::uint32_t none = ~0U;
constexpr std::size_t recent = 1024;  ///< a power of 2

bool is_multiple(const Mat3& m) { return m == Mat3(m[0][0]); }

std::size_t hash_of(const Mat3& m) {
  std::uint64_t hash = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      // -0 equals 0.
      const auto bits = std::bit_cast<std::uint64_t>(m[column][row] + 0.0);
      hash = std::rotl((hash ^ bits) * golden64, 29);
    }
  }
  return mix64(hash) % recent;
}

template <class T>
std::uint32_t appended(std::vector<T>& to, T entry) {
  to.push_back(std::move(entry));
  return static_cast<std::uint32_t>(to.size() - 1);
}

template <class T>
std::size_t bytes_of(const std::vector<T>& v) {
  return v.size() * sizeof(T);
}

}  // namespace

Placement MovedMap::placement() const {
  Placement p;
  p.render_from_model.offset = to_render;
  p.model_from_render.offset = to_model;
  p.moved_only = true;
  return p;
}

Placement ScaledMap::placement() const {
  Placement p;
  p.render_from_model = {Mat3(render_factor), to_render};
  p.model_from_render = {Mat3(model_factor), to_model};
  p.render_per_model = render_per_model();
  p.model_per_render = model_per_render();
  return p;
}

Placement LinearMap::placement() const {
  Placement p;
  p.render_from_model = {parts.to_render, to_render};
  p.model_from_render = {parts.to_model, to_model};
  p.render_per_model = parts.render_per_model;
  p.model_per_render = parts.model_per_render;
  return p;
}

PlacementTable::Id PlacementTable::add(const Placement& placement) {
  const auto& [to_render, render_offset] = placement.render_from_model;
  const auto& [to_model, model_offset] = placement.model_from_render;
  if (placement.moved_only) {
    // What is placed by its own parameters is moved from the eye, all of it alike.
    const MovedMap map{render_offset, model_offset};
    const bool again = !moved_.empty() && moved_.back() == map;
    const auto last = static_cast<std::uint32_t>(moved_.size()) - 1;
    return {MapKind::moved, again ? last : appended(moved_, map)};
  }
  if (is_multiple(to_render) && is_multiple(to_model)) {
    return {MapKind::scaled,
            appended(scaled_, {render_offset, model_offset, to_render[0][0], to_model[0][0]})};
  }
  return {MapKind::linear, appended(linear_, {render_offset, model_offset, parts_of(placement)})};
}

PlacementTable::Id PlacementTable::add(const Placement& at_open, PlannedMotion motion) {
  return {MapKind::moving, appended(moving_, {at_open, std::move(motion)})};
}

std::uint32_t PlacementTable::parts_of(const Placement& placement) {
  const Mat3& to_render = placement.render_from_model.linear;
  const Mat3& to_model = placement.model_from_render.linear;
  recent_parts_.resize(recent, none);
  std::uint32_t& last = recent_parts_[hash_of(to_render)];
  if (last == none || parts_[last].to_render != to_render || parts_[last].to_model != to_model) {
    last = appended(parts_,
                    {to_render, to_model, placement.render_per_model, placement.model_per_render});
  }
  return last;
}

Placement PlacementTable::at_open(MapKind kind, std::uint32_t index) const {
  return kind == MapKind::moving ? moving_[index].at_open : at(kind, index, 0.0);
}

Placement PlacementTable::at(MapKind kind, std::uint32_t index, double time) const {
  return visit(kind, index, time, [](const auto& map) { return map.placement(); });
}

std::size_t PlacementTable::bytes() const {
  std::size_t keys = 0;
  for (const Moving& m : moving_) {
    keys += bytes_of(m.motion.keys);
  }
  return bytes_of(moved_) + bytes_of(scaled_) + bytes_of(linear_) + bytes_of(parts_) +
         bytes_of(moving_) + bytes_of(recent_parts_) + keys;
}

}  // namespace rt
