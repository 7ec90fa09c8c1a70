#pragma once
/// Adaptive supersampling of a tile.
#include <atomic>
#include <chrono>
#include <optional>
#include <span>
#include <vector>

#include "rt/math/bytes.h"
#include "rt/render/pixel_results.h"
#include "rt/render/sample.h"

namespace rt {

/// First samples of every pixel. With the neighbours' 16 they tell an even region from an edge
/// (bench/NOTES.md).
inline constexpr std::uint32_t pilot_samples = 2;

class PilotRow;
class RowContrast;

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

  /// Takes every pixel's first samples, estimates errors, and gives what comes of that to
  /// `results`; keeps those pixels that max_error asks more of. Told to stop it gives up: then
  /// begun() is false, and nothing has been counted nor given.
  void pilots(PixelSampler& sampler, PixelResults& results, const Deadline& deadline,
              RenderStatistics& statistics);
  bool begun() const { return begun_; }
  /// Doubles the samples of every pixel whose estimated error is above `target` >= max_error until
  /// it is not, or it has max_samples; true when all are there. Stops when time is up.
  bool refine(PixelSampler& sampler, double target, const Deadline& deadline,
              RenderStatistics& statistics);
  /// Gives the pixels that are kept, as far as they are.
  void give(PixelResults& results) const;
  /// Lets go of all pixels.
  void release();

  /// The pixels that are kept, once begun: all that refine() needs.
  void save(ByteWriter& out) const;
  /// How many bytes save() writes.
  std::size_t state_bytes() const;
  /// Throws std::out_of_range for what cannot be pixels that may take `most` samples.
  void load(ByteReader& in, std::uint32_t most);

 private:
  struct Open {
    PixelEstimate estimate;
    int x, y;  ///< in the picture
  };

  void take_rows(PixelSampler& sampler, int top, int bottom, std::span<PilotRow> rows,
                 RenderStatistics& statistics) const;
  void estimate_row(PixelSampler& sampler, int y, std::span<const PilotRow> rows,
                    RowContrast& contrast, PixelResults& results, RenderStatistics& statistics);
  void begin_pixel(PixelSampler& sampler, int x, int y, std::span<const std::optional<Rgb>> values,
                   const Rgb& contrast, float error, PixelResults& results,
                   RenderStatistics& statistics);
  /// Kept from call to call.
  struct Buffers {
    std::vector<PixelSample> wanted;
    std::vector<std::optional<Rgb>> values;
  };
  static void double_samples(PixelSampler& sampler, std::span<Open* const> pixels,
                             Buffers& buffers, RenderStatistics& statistics);

  Crop area_;
  bool begun_ = false;
  std::vector<Open> open_;  ///< row by row
};

}  // namespace rt
