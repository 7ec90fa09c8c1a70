#pragma once
/// One sample of a pixel: the camera's ray at a place on the pixel's filter and on the lens.
#include <optional>
#include <span>

#include "rt/render/accel/sight_cache.h"
#include "rt/render/packet/packet_tracer.h"
#include "rt/render/statistics.h"
#include "rt/render/tracer.h"

namespace rt {

/// A sample that is wanted.
struct PixelSample {
  int x, y;
  Sampler sampler;
  bool at_centre = false;  ///< of the pixel; otherwise where the filter says
};

/// Takes samples. One a thread.
class PixelSampler {
 public:
  explicit PixelSampler(const RenderPlan& plan);

  const RenderPlan& plan() const { return tracer_.plan(); }

  /// The radiance that arrives at pixel (x, y) from where `sample` says, filter-distributed. Empty,
  /// and counted as a bad sample, when it is not finite.
  std::optional<Rgb> take(int x, int y, const Sampler& sample, RenderStatistics& statistics);

  /// The same at an offset from the pixel's top left corner, in pixels.
  std::optional<Rgb> take_at(int x, int y, const Vec2& offset, const Sampler& sample,
                             RenderStatistics& statistics);

  /// Those samples, as take() would; several at a time where the scene allows. Neighbours should be
  /// next to each other.
  void take_all(std::span<const PixelSample> wanted, std::span<std::optional<Rgb>> values,
                RenderStatistics& statistics);

 private:
  void take_packet(std::span<const PixelSample> wanted, std::span<std::optional<Rgb>> values,
                   RenderStatistics& statistics);
  Candidates sight_of(const std::array<Vec2, lanes>& places, unsigned count);

  Tracer tracer_;
  SightCache sight_;
  std::optional<PacketTracer> packets_;  ///< where it serves
  std::vector<std::uint32_t> union_;     ///< of what several blocks show
};

}  // namespace rt
