#include "rt/render/placement_table.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "rt/math/hash.h"
#include "rt/math/rounding.h"

namespace rt {
namespace {

constexpr std::size_t recent = 256;  ///< a power of 2

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

/// The factor f such that the transpose of m times f^2 is its inverse, as TurnedMap wants it; 0 if
/// there is none. In extended precision, which leaves rounding what f and m already have of it.
double factor_of_turn(const Mat3& m) {
  using Long = long double;
  const auto product = [&](int i, int j) {
    return Long(m[i].x) * m[j].x + Long(m[i].y) * m[j].y + Long(m[i].z) * m[j].z;
  };
  const Long square = (product(0, 0) + product(1, 1) + product(2, 2)) / 3;
  const auto f = static_cast<double>(1 / std::sqrt(square));
  const Long factor = Long(f) * f;
  Long off = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      off = std::max(off, std::abs(product(i, j) * factor - (i == j ? 1 : 0)));
    }
  }
  // Where the square of f is not a number that has all its bits there is none, either.
  const bool normal = std::isnormal(f * f) && std::isnormal(1 / f);
  return normal && off <= Long(12 * unit_roundoff) ? f : 0.0;
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
  p.render_from_model.offset = offset;
  p.model_from_render.offset = -offset;
  p.moved_only = true;
  return p;
}

Placement ScaledMap::placement() const {
  Placement p;
  p.render_from_model = {Mat3(render_factor), offset};
  p.model_from_render = {Mat3(model_factor), model_factor * -offset};
  p.render_per_model = render_per_model();
  p.model_per_render = model_per_render();
  return p;
}

Placement TurnedMap::placement() const {
  Placement p;
  p.render_from_model = {to_render, offset};
  p.model_from_render = {(model_factor * model_factor) * glm::transpose(to_render),
                         model_vector(-offset)};
  p.render_per_model = render_per_model();
  p.model_per_render = model_per_render();
  return p;
}

Placement LinearMap::placement() const {
  Placement p;
  p.render_from_model = {parts.to_render, offset};
  p.model_from_render = {parts.to_model, to_model};
  p.render_per_model = parts.render_per_model;
  p.model_per_render = parts.model_per_render;
  return p;
}

PlacementTable::Id PlacementTable::add(const Placement& placement, bool round) {
  const auto& [to_render, offset] = placement.render_from_model;
  const Mat3& to_model = placement.model_from_render.linear;
  if (placement.moved_only) {
    // What is placed by its own parameters is moved from the eye, all of it alike.
    const MovedMap map{offset};
    const bool again = !moved_.empty() && moved_.back() == map;
    const auto last = static_cast<std::uint32_t>(moved_.size()) - 1;
    return {MapKind::moved, again ? last : appended(moved_, map)};
  }
  if (is_multiple(to_render) && is_multiple(to_model)) {
    return {MapKind::scaled, appended(scaled_, {offset, to_render[0][0], to_model[0][0]})};
  }
  if (const double factor = round ? factor_of_turn(to_render) : 0.0; factor > 0.0) {
    const Affine unturned{Mat3(1 / factor), offset};
    return add({unturned, {Mat3(factor), factor * -offset}});
  }
  return add_linear(placement);
}

/// Linear parts that come again are kept once; of a turn that does not, less is kept.
PlacementTable::Id PlacementTable::add_linear(const Placement& placement) {
  const auto& [to_render, offset] = placement.render_from_model;
  const auto& [to_model, model_offset] = placement.model_from_render;
  recent_.resize(recent);
  Met& met = recent_[hash_of(to_render)];
  if (met.to_render != to_render || met.to_model != to_model) {
    met = {to_render, to_model, none};
    if (const double factor = factor_of_turn(to_render); factor > 0.0) {
      return {MapKind::turned, appended(turned_, {offset, to_render, factor})};
    }
  }
  if (met.parts == none) {
    met.parts = appended(
        parts_, {to_render, to_model, placement.render_per_model, placement.model_per_render});
  }
  return {MapKind::linear, appended(linear_, {offset, model_offset, met.parts})};
}

PlacementTable::Id PlacementTable::add(const Placement& at_open, PlannedMotion motion) {
  return {MapKind::moving, appended(moving_, {at_open, std::move(motion)})};
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
  return bytes_of(moved_) + bytes_of(scaled_) + bytes_of(turned_) + bytes_of(linear_) +
         bytes_of(parts_) + bytes_of(moving_) + bytes_of(recent_) + keys;
}

}  // namespace rt
