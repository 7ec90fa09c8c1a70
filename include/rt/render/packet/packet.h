#pragma once
/// Rays of several samples that go the same way, and their hits.
#include "rt/geometry/wide_shapes.h"
#include "rt/render/trace.h"

namespace rt {

/// An instance for each lane.
using Ids = stdx::rebind_simd_t<std::uint32_t, Wide>;

inline unsigned lanes_where(const Ids& ids, std::uint32_t id) {
  const Ids::mask_type same = ids == id;
  return static_cast<unsigned>(same.__to_bitset().to_ulong());
}

/// Calls visit(instance, lanes) for every instance that lanes of `bits` have.
template <class Visit>
void each_instance(const Ids& ids, unsigned bits, Visit&& visit) {
  while (bits != 0) {
    const std::uint32_t id = ids[static_cast<std::size_t>(std::countr_zero(bits))];
    const unsigned same = lanes_where(ids, id) & bits;
    visit(id, same);
    bits &= ~same;
  }
}

/// As many rays as a vector register holds doubles: from the camera, or all from surfaces.
struct Packet {
  WideRay ray;          ///< in render space; directions of unit length
  unsigned active = 0;  ///< the lanes that hold a ray
  Wide position_error{0.0};
  bool from_surface = false;
  Ids instance{no_instance};  ///< that they have left
  Wide feature{0.0};          ///< of it; as all features here, a whole number
  unsigned outward = 0;       ///< the lanes that have left it outward; the others inward
  const Wide* time = nullptr; ///< of each, where something moves

  TraceRay lane(int i) const {
    const auto at = static_cast<std::size_t>(i);
    TraceRay r{ray.origin.lane(i), ray.direction.lane(i)};
    if (time != nullptr) {
      r.time = (*time)[at];
    }
    if (from_surface) {
      r.instance = instance[at];
      r.feature = static_cast<std::uint32_t>(feature[at]);
      r.leaving = (outward >> i & 1U) != 0 ? Leaving::outward : Leaving::inward;
      r.position_error = position_error[at];
    }
    return r;
  }
};

/// Their nearest crossings: as SceneHit.
struct PacketHits {
  Wide t{std::numeric_limits<double>::infinity()};
  Wide feature{0.0};
  Ids instance{no_instance};  ///< no_instance: none

  SceneHit lane(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return {t[at], instance[at], static_cast<std::uint32_t>(feature[at])};
  }
};

}  // namespace rt
