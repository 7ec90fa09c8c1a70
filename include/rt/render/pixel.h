#pragma once
/// Pixels that take a fixed number of samples, or the classic scheme's.
#include <span>
#include <vector>

#include "rt/render/adaptive.h"
#include "rt/render/film.h"
#include "rt/render/sample.h"

namespace rt {

/// The means over `count` samples of each pixel from (x, y) to the right; false when told to stop.
bool uniform_row(PixelSampler& sampler, int x, int y, int count, std::span<Rgb> row,
                 const Deadline& deadline, RenderStatistics& statistics);

/// The classic scheme: the pixel's square is divided in four as long as the colours at its corners
/// differ by more than 0.1, at most five times, and a square that is not is the mean of its
/// corners. Neighbours share corners (those on common edges are the same samples). Its filter is
/// the box; it never looks inside a square whose corners agree.
class CornerTile {
 public:
  CornerTile(PixelSampler& sampler, const Crop& tile, RenderStatistics& statistics);
  /// Of a pixel of the tile.
  Rgb value(int x, int y);

 private:
  static constexpr int levels = 5;
  static constexpr int edge = 1 << levels;  ///< intervals along a pixel's side

  Rgb traced(int x, int y, int i, int j);
  Rgb corner(int i, int j);
  Rgb square(int i, int j, int size);

  PixelSampler& sampler_;
  Crop tile_;
  RenderStatistics& statistics_;
  std::vector<Rgb> grid_;    ///< at the corners of the tile's pixels
  std::vector<Rgb> inside_;  ///< of the pixel at hand
  std::vector<int> taken_;   ///< the pixel, counted from 1, that a value in `inside_` is of
  int pixel_ = 0;
  int x_ = 0, y_ = 0;
};

}  // namespace rt
