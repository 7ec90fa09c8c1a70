#pragma once
/// Rays of several samples that go the same way, and their hits.
#include "rt/geometry/wide_shapes.h"
#include "rt/render/trace.h"

namespace rt {

/// As many rays as a vector register holds doubles. Those from a surface have all left the same
/// instance.
struct Packet {
  WideRay ray;          ///< in render space; directions of unit length
  unsigned active = 0;  ///< the lanes that hold a ray
  Wide position_error{0.0};
  std::uint32_t instance = no_instance;  ///< that all have left
  Wide feature{0.0};                     ///< of it; as all features here, a whole number
  unsigned outward = 0;                  ///< the lanes that have left it outward; the others inward

  TraceRay lane(int i) const {
    TraceRay r{ray.origin.lane(i), ray.direction.lane(i)};
    if (instance != no_instance) {
      const auto at = static_cast<std::size_t>(i);
      r.instance = instance;
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
  std::array<std::uint32_t, lanes> instance;  ///< no_instance: none

  SceneHit lane(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return {t[at], instance[at], static_cast<std::uint32_t>(feature[at])};
  }
};

}  // namespace rt
