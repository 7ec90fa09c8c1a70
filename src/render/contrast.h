#pragma once
/// How much the first samples of three by three pixels differ: the contrast of estimate.h, for a row
/// of pixels at a time.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "rt/math/vec.h"
#include "rt/math/wide.h"

namespace rt {

/// What a neighbour's sample counts for the contrast when it lies in a quadrant that does not touch
/// the pixel; others count 1.
inline constexpr double far_weight = 0.125;

/// The first samples of a row of pixels, by the quadrant of the pixel in which they lie; not every
/// quadrant has one.
class PilotRow {
 public:
  // The last pixels are read by as many as a register holds.
  explicit PilotRow(std::size_t pixels) : stride_(pixels + lanes), values_(16 * stride_) {}

  /// No pixel has any.
  void clear() { std::ranges::fill(values_, 0.0); }

  /// A pixel's next sample; a quadrant has one at most.
  void add(std::size_t pixel, int quadrant, const Rgb& value) {
    for (int c = 0; c < 3; ++c) {
      values_[index(quadrant, c) + pixel] = value[c];
    }
    values_[index(quadrant, 3) + pixel] = 1.0;
  }

  /// Channel c of a quadrant of so many pixels from `pixel` on, or (c = 3) 1 where there is a
  /// sample; 0 where there is none. Bit 0 of a quadrant says right, bit 1 bottom.
  Wide get(int quadrant, int c, std::size_t pixel) const {
    return Wide(&values_[index(quadrant, c) + pixel], stdx::element_aligned);
  }

  /// Calls f(sample) for those of a pixel.
  template <class F>
  void each_of(std::size_t pixel, F&& f) const {
    for (int q = 0; q < 4; ++q) {
      const auto at = [&](int c) { return values_[index(q, c) + pixel]; };
      if (at(3) != 0.0) {
        f(Rgb(at(0), at(1), at(2)));
      }
    }
  }

 private:
  std::size_t index(int quadrant, int c) const {
    return static_cast<std::size_t>(4 * quadrant + c) * stride_;
  }

  std::size_t stride_;
  std::vector<double> values_;  ///< by quadrant, channel, pixel
};

/// Sums over the three by three pixels about each of a row, quadrants that do not touch it weighted
/// less: first along the columns of quadrants, two a pixel, then across.
class SumsAbout {
 public:
  explicit SumsAbout(std::size_t pixels) : stride_(pixels + lanes), columns_(4 * stride_) {}

  /// Of f(value) over channel c; the row is the second of three.
  template <class F>
  void add_up(const std::array<const PilotRow*, 3>& rows, int c, F&& f) {
    for (std::size_t x = 0; x + lanes <= stride_; x += lanes) {
      for (int right = 0; right < 2; ++right) {
        const auto value = [&](std::size_t row, int bottom) {
          return f(rows[row]->get(2 * bottom + right, c, x));
        };
        const Wide near = (value(0, 1) + value(1, 0)) + (value(1, 1) + value(2, 0));
        const Wide far = value(0, 0) + value(2, 1);
        (near + far_weight * far).copy_to(&columns_[index(right, 0, x)], stdx::element_aligned);
        (far_weight * (near + far)).copy_to(&columns_[index(right, 1, x)], stdx::element_aligned);
      }
    }
  }

  /// About so many pixels from `pixel` on; not the row's first.
  Wide about(std::size_t pixel) const {
    const auto sum = [&](int right, int far, std::size_t x) {
      return Wide(&columns_[index(right, far, x)], stdx::element_aligned);
    };
    const Wide near = (sum(1, 0, pixel - 1) + sum(0, 0, pixel)) +
                      (sum(1, 0, pixel) + sum(0, 0, pixel + 1));
    return near + (sum(0, 1, pixel - 1) + sum(1, 1, pixel + 1));
  }

 private:
  std::size_t index(int right, int far, std::size_t x) const {
    return static_cast<std::size_t>(2 * far + right) * stride_ + x;
  }

  std::size_t stride_;
  std::vector<double> columns_;
};

/// The variance of the samples about each pixel of a row.
class RowContrast {
 public:
  explicit RowContrast(std::size_t pixels)
      : number_(pixels), values_(3, SumsAbout(pixels)), squares_(values_) {}

  /// Of the second of three rows.
  void add_up(const std::array<const PilotRow*, 3>& rows) {
    number_.add_up(rows, 3, [](const Wide& v) { return v; });
    for (int c = 0; c < 3; ++c) {
      values_[static_cast<std::size_t>(c)].add_up(rows, c, [](const Wide& v) { return v; });
      squares_[static_cast<std::size_t>(c)].add_up(rows, c, [](const Wide& v) { return v * v; });
    }
  }

  /// About so many pixels from `pixel` on; not the row's first.
  Wide3 variance(std::size_t pixel) const {
    const Wide weight = max(number_.about(pixel), Wide(far_weight));  // there may be none
    const auto channel = [&](std::size_t c) {
      const Wide mean = values_[c].about(pixel) / weight;
      return max(squares_[c].about(pixel) / weight - mean * mean, Wide(0.0));
    };
    return {channel(0), channel(1), channel(2)};
  }

 private:
  SumsAbout number_;
  std::vector<SumsAbout> values_, squares_;  ///< by channel
};

/// So many pixels' own first samples, from `pixel` on.
struct OwnPilots {
  OwnPilots(const PilotRow& row, std::size_t pixel) {
    const auto sum = [&](int c) {
      return (row.get(0, c, pixel) + row.get(1, c, pixel)) +
             (row.get(2, c, pixel) + row.get(3, c, pixel));
    };
    number = sum(3);
    mean = Wide3(sum(0), sum(1), sum(2)) / max(number, Wide(1.0));
  }

  Wide number;
  Wide3 mean;
};

}  // namespace rt
