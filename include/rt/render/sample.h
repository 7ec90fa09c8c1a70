#pragma once
/// One sample of a pixel: the camera's ray at a place on the pixel's filter and on the lens.
#include <optional>

#include "rt/render/accel/sight_cache.h"
#include "rt/render/statistics.h"
#include "rt/render/tracer.h"

namespace rt {

/// Takes samples. One a thread.
class PixelSampler {
 public:
  explicit PixelSampler(const RenderPlan& plan) : tracer_(plan), sight_(plan) {}

  const RenderPlan& plan() const { return tracer_.plan(); }

  /// The radiance that arrives at pixel (x, y) from where `sample` says, filter-distributed. Empty,
  /// and counted as a bad sample, when it is not finite.
  std::optional<Rgb> take(int x, int y, const Sampler& sample, RenderStatistics& statistics);

  /// The same at an offset from the pixel's top left corner, in pixels.
  std::optional<Rgb> take_at(int x, int y, const Vec2& offset, const Sampler& sample,
                             RenderStatistics& statistics);

 private:
  Tracer tracer_;
  SightCache sight_;
};

}  // namespace rt
