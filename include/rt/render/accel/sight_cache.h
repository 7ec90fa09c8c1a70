#pragma once
/// What a small part of the picture may show.
#include <array>
#include <vector>

#include "rt/render/accel/candidates.h"
#include "rt/render/plan.h"

namespace rt {

/// Divides the picture into blocks of a few pixels and keeps for each the instances that meet the
/// pyramid through it, where these are few: the camera's rays then need no search. Pyramids are
/// conservative, so rays find the same hits with the cache as without. For cameras that have no
/// lens and stand still.
///
/// One a thread, of 16 KB.
class SightCache {
 public:
  explicit SightCache(const RenderPlan& plan);

  /// For camera rays through (x, y), in pixels from the picture's top left.
  Candidates through(double x, double y);

  /// Edge of a block, in pixels: through() answers alike for all places of one.
  static constexpr int block = 8;

 private:
  static constexpr std::size_t entries = 256;
  static constexpr std::size_t most = 12;

  struct alignas(64) Entry {
    int x, y;
    bool filled = false;
    bool few = false;
    std::uint8_t count = 0;
    std::array<std::uint32_t, most> instances;
  };

  void fill(Entry& entry) const;

  const RenderPlan& plan_;
  std::vector<Entry> table_;
};

}  // namespace rt
