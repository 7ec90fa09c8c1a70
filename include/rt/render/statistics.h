#pragma once
#include <cstdint>

#include "rt/render/shading.h"

namespace rt {

/// What a rendering tells about itself.
struct RenderStatistics {
  RayCounts rays;
  std::uint64_t samples = 0;  ///< those that a tile took of its neighbours' pixels included
  double cpu_seconds = 0.0;   ///< processor time of the threads that traced
  /// Samples whose radiance was NaN or infinite: left out of their pixel's mean.
  std::uint64_t bad_samples = 0;
  int first_bad_x = 0, first_bad_y = 0;  ///< the topmost, leftmost pixel with one

  void add_bad(int x, int y);
  RenderStatistics& operator+=(const RenderStatistics& other);
};

}  // namespace rt
