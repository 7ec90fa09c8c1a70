#pragma once
/// Adaptive supersampling of a tile.
#include <chrono>
#include <vector>

#include "rt/render/estimate.h"
#include "rt/render/film.h"
#include "rt/render/sample.h"

namespace rt {

/// First samples of every pixel. With the neighbours' 36 samples tell an even region from an edge.
inline constexpr std::uint32_t pilot_samples = 4;

/// When to stop before the error is reached.
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;
  Deadline() = default;
  explicit Deadline(double seconds)
      : end_(Clock::now() +
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
        limited_(true) {}
  bool passed() const { return limited_ && Clock::now() >= end_; }

 private:
  Clock::time_point end_;
  bool limited_ = false;
};

/// The pixels of a tile, on their way to an error. Every pixel's samples depend on itself and on
/// the pilots of its eight neighbours alone; those beyond the tile's edge are taken here again, so
/// a pixel is the same in any tile.
class AdaptiveTile {
 public:
  explicit AdaptiveTile(const Crop& area) : area_(area) {}

  const Crop& area() const { return area_; }
  /// Takes every pixel's first samples, and estimates errors.
  void pilots(PixelSampler& sampler, RenderStatistics& statistics);
  /// Doubles the samples of every pixel whose estimated error is above `target` until it is not, or
  /// it has max_samples. Stops when time is up.
  void refine(PixelSampler& sampler, double target, const Deadline& deadline,
              RenderStatistics& statistics);
  /// The estimate for a pixel of the area, at picture coordinates.
  const PixelEstimate& at(int x, int y) const { return pixels_[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>((y - area_.y + 1) * (area_.width + 2) + (x - area_.x + 1));
  }
  void estimate_from_contrast(PixelEstimate& e, int x, int y, const RenderPlan& plan) const;

  Crop area_;
  std::vector<PixelEstimate> pixels_;  ///< row by row, with a border of one pixel
};

}  // namespace rt
