#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "rt/render/film.h"
#include "rt/render/plan.h"
#include "rt/render/statistics.h"

namespace rt {

/// How near the picture came to its error target; of adaptive renderings only.
struct ReachedError {
  double mean = 0.0;            ///< of the pixels' estimated errors, displayed units
  double percentile_99 = 0.0;   ///< exceeded by one pixel in a hundred
  std::uint64_t unreached = 0;  ///< pixels whose estimate stayed above max_error
  bool out_of_time = false;     ///< because of the time limit; else because of max_samples
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
  std::optional<ReachedError> reached;
  // Of adaptive renderings, pixel by pixel as in the film.
  std::vector<float> errors;  ///< estimated, displayed units
  std::vector<std::uint32_t> samples;
  std::vector<std::uint32_t> pilots;  ///< of them, taken before any error was estimated
};

/// Renders a part of the picture, with the threads that with_threads() gives. The result depends on
/// the plan alone: not on the number of threads, nor on the crop, whose pixels equal those of the
/// full picture. (With a time limit it depends on the clock; given time enough it is the same.)
RenderResult render(const RenderPlan& plan, const Crop& crop, const ProgressFunction& progress);

}  // namespace rt
