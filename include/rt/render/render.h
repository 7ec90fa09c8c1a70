#pragma once
#include <functional>

#include "rt/render/film.h"
#include "rt/render/shading.h"

namespace rt {

/// What a rendering tells about itself.
struct RenderStatistics {
  RayCounts rays;
  std::uint64_t samples = 0;
  double cpu_seconds = 0.0;  ///< processor time of the threads that traced
  /// Samples whose radiance was NaN or infinite: left out of their pixel's mean.
  std::uint64_t bad_samples = 0;
  int first_bad_x = 0, first_bad_y = 0;  ///< the topmost, leftmost pixel with one
};

/// How far a rendering is; called from its threads, one at a time.
struct Progress {
  double fraction;     ///< of pixels, in [0,1]
  std::uint64_t rays;  ///< so far
};
using ProgressFunction = std::function<void(const Progress&)>;

struct RenderResult {
  Film film;
  RenderStatistics statistics;
};

/// Renders a part of the picture, with the threads that with_threads() gives. The result depends on
/// the plan alone: not on the number of threads, nor on the crop, whose pixels equal those of the
/// full picture.
RenderResult render(const RenderPlan& plan, const Crop& crop, const ProgressFunction& progress);

}  // namespace rt
