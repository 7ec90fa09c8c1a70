#pragma once
/// What may stand between a small piece of space and a light.
#include <array>
#include <cstdint>
#include <vector>

#include "rt/math/wide.h"
#include "rt/render/accel/candidates.h"
#include "rt/render/plan.h"

namespace rt {

/// Neighbouring points see a light past the same few things. Space is divided into cells some
/// pixels wide as seen from the eye; for the second point of a cell that asks, the instances that
/// meet the shaft from the cell to the light are looked for, and kept for all others. Mostly there
/// are none: then no shadow ray need be traced at all. Answers do not depend on what was asked
/// before: shafts are conservative, so a ray finds the same blockers with the cache as without.
///
/// One a thread, of 16 KB and 112 KB of lists.
class ShadowCache {
 public:
  explicit ShadowCache(const RenderPlan& plan);

  /// How many are few.
  static constexpr std::size_t most = 28;

  /// Numbers a cell: below 2^47, so that a double holds it; `nowhere` where space is not divided.
  using Cell = std::uint64_t;
  static constexpr Cell nowhere = 0;
  Cell cell_of(const Vec3& position) const;
  /// The same numbers for several positions.
  Wide cells_of(const Wide3& positions) const;

  /// For shadow rays from anywhere in `cell` towards light `light`. `at_once`: even when nobody has
  /// asked in this cell before; then the answer is the same whatever was asked.
  Candidates towards(std::size_t light, Cell cell, bool at_once = false);

  /// The instance that has hidden a light last, as whoever asks sees it; at first no_instance.
  std::uint32_t& last_blocker(std::size_t light) { return last_blockers_[light]; }

 private:
  static constexpr std::size_t entries = 1024;
  enum class State : std::uint8_t { unknown, many, known };

  /// Mostly there are no instances: then this is all that is looked at, and all of them stay in the
  /// nearest cache.
  struct Entry {
    std::uint64_t key = 0;  ///< of cell and light
    State state = State::unknown;
    bool dims = false;
    std::uint16_t count = 0;  ///< of its instances
  };
  using Instances = std::array<std::uint32_t, most>;
  /// What was asked about last, and its entry, for as long as that is not another's.
  struct Last {
    std::uint64_t key = 0;
    const Entry* entry = nullptr;
  };

  Candidates answer(const Entry& entry) const {
    return {entry.state == State::known, entry.dims, {instances_[place(entry)].data(), entry.count}};
  }
  std::size_t place(const Entry& entry) const {
    return static_cast<std::size_t>(&entry - table_.data());
  }
  Bounds bounds_of(Cell cell) const;
  void fill(Entry& entry, Cell cell, std::size_t light);
  bool add(Entry& entry, std::uint32_t instance);

  const RenderPlan& plan_;
  int fineness_;  ///< cells are 2^-fineness of the power of two below their distance
  std::vector<Bounds> lights_;
  std::vector<Last> last_;  ///< by light
  std::vector<std::uint32_t> last_blockers_;
  std::vector<Entry> table_;
  std::vector<Instances> instances_;  ///< of the entries
};

}  // namespace rt
