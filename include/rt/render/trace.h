#pragma once
/// Rays and hits as the renderer passes them on. They live in render space: the world moved so that
/// the camera's eye is the origin. A scene far from the world's origin loses nothing by it.
#include <cstdint>
#include <limits>

#include "rt/geometry/hit.h"

namespace rt {

inline constexpr std::uint32_t no_instance = std::numeric_limits<std::uint32_t>::max();

/// A ray, and what is known of the surface it starts on.
struct TraceRay {
  Vec3 origin;
  Vec3 direction;                        ///< unit, so that t is a distance
  std::uint32_t instance = no_instance;  ///< the instance left; none for camera rays
  std::uint32_t feature = 0;
  Leaving leaving = Leaving::nothing;
  double position_error = 0.0;  ///< of the origin, render units; 0 for camera rays
  double time = 0.0;            ///< in [0,1], while the shutter is open
};

/// The nearest crossing of the scene along a ray.
struct SceneHit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t instance = no_instance;
  std::uint32_t feature = 0;
};

}  // namespace rt
