#pragma once
/// One sample of a pixel: the camera's ray at a place on the pixel's filter and on the lens.
#include <memory>
#include <optional>
#include <span>

#include "rt/render/accel/sight_cache.h"
#include "rt/render/film.h"
#include "rt/render/statistics.h"
#include "rt/render/tracer.h"

namespace rt {

class PacketSampler;

/// A sample that is wanted.
struct PixelSample {
  int x, y;
  std::uint32_t index;
};

/// The ray through picture coordinates in [0,1]^2, not normalised. With a lens it starts anywhere on
/// it and meets the others of that place in the plane in focus; where something moves, it has a time
/// of its own.
TraceRay camera_ray(const RenderPlan& plan, double px, double py, const Sampler& sample);

/// Takes samples. One a thread.
class PixelSampler {
 public:
  explicit PixelSampler(const RenderPlan& plan);
  ~PixelSampler();
  PixelSampler(PixelSampler&&) noexcept;

  const RenderPlan& plan() const { return tracer_.plan(); }

  /// The radiance that arrives at pixel (x, y) from where `sample` says, filter-distributed. Empty,
  /// and counted as a bad sample, when it is not finite.
  std::optional<Rgb> take(int x, int y, const Sampler& sample, RenderStatistics& statistics);

  /// The same at an offset from the pixel's top left corner, in pixels.
  std::optional<Rgb> take_at(int x, int y, const Vec2& offset, const Sampler& sample,
                             RenderStatistics& statistics);

  /// Those samples, as take() would, but several at a time. Neighbours should be
  /// next to each other. If asked, says in which quadrant of its pixel each lies: bit 0 is set on the
  /// right, bit 1 at the bottom.
  void take_all(std::span<const PixelSample> wanted, std::span<std::optional<Rgb>> values,
                RenderStatistics& statistics, std::span<std::uint8_t> quadrants = {});

  /// Sample 0 of every pixel of a tile, but at the pixel's centre, as take_at() would, into the film
  /// of `crop`; black where it is not finite.
  void take_centres(const Crop& tile, const Crop& crop, Film& film, RenderStatistics& statistics);

 private:
  Tracer tracer_;
  SightCache sight_;
  std::unique_ptr<PacketSampler> packets_;
};

}  // namespace rt
