#pragma once
/// Adaptive supersampling of a tile.
#include <atomic>
#include <chrono>
#include <optional>
#include <span>
#include <vector>

#include "rt/math/bytes.h"
#include "rt/render/estimate.h"
#include "rt/render/film.h"
#include "rt/render/sample.h"

namespace rt {

/// First samples of every pixel. With the neighbours' 16 they tell an even region from an edge
/// (bench/NOTES.md).
inline constexpr std::uint32_t pilot_samples = 2;

/// When to stop before the error is reached: at a time, or when told to.
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;
  explicit Deadline(std::optional<Clock::time_point> end = {},
                    const std::atomic<bool>* stop = nullptr)
      : end_(end), stop_(stop) {}
  bool told() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }
  bool passed() const { return told() || (end_ && Clock::now() >= *end_); }

 private:
  std::optional<Clock::time_point> end_;
  const std::atomic<bool>* stop_;
};

/// The pixels of a tile, on their way to an error. Every pixel's samples depend on itself and on
/// the pilots of its eight neighbours alone; those beyond the tile's edge are taken here again, so
/// a pixel is the same in any tile.
class AdaptiveTile {
 public:
  explicit AdaptiveTile(const Crop& area) : area_(area) {}

  const Crop& area() const { return area_; }
  /// Takes every pixel's first samples, and estimates errors. Told to stop it gives up: then there
  /// are no pilots (begun() is false), and nothing has been counted.
  void pilots(PixelSampler& sampler, const Deadline& deadline, RenderStatistics& statistics);
  bool begun() const { return !pixels_.empty(); }
  /// Doubles the samples of every pixel whose estimated error is above `target` until it is not, or
  /// it has max_samples; true when all are there. Stops when time is up.
  bool refine(PixelSampler& sampler, double target, const Deadline& deadline,
              RenderStatistics& statistics);
  /// Lets go of all pixels.
  void release() { std::vector<PixelEstimate>().swap(pixels_); }

  /// The pixels of the area, once begun: all that refine() needs.
  void save(ByteWriter& out) const;
  /// Throws std::out_of_range for what cannot be pixels that may take `most` samples.
  void load(ByteReader& in, std::uint32_t most);

  /// The estimate for a pixel of the area, at picture coordinates.
  const PixelEstimate& at(int x, int y) const { return pixels_[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>((y - area_.y) * area_.width + (x - area_.x));
  }
  void begin_row(PixelSampler& sampler, int y, std::span<const std::optional<Rgb>> values,
                 RenderStatistics& statistics);

  Crop area_;
  std::vector<PixelEstimate> pixels_;  ///< row by row
};

}  // namespace rt
