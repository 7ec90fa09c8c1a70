#pragma once
#include "rt/render/estimate.h"
#include "rt/render/render.h"

namespace rt {

/// The pixels of a RenderResult, which tiles fill, each its own.
class PixelResults {
 public:
  /// Of the crop's pixels.
  PixelResults(RenderResult& result, const Crop& crop) : result_(result), crop_(crop) {}

  /// At picture coordinates.
  void set(int x, int y, const PixelEstimate& e);
  /// Of `count` pixels in a row that took `pilots` samples.
  void set_row(int x, int y, int count, const Wide3& means, const Wide& errors,
               std::uint32_t pilots);
  /// Takes back what an area was given.
  void clear(const Crop& area);

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - crop_.y) * static_cast<std::size_t>(crop_.width) +
           static_cast<std::size_t>(x - crop_.x);
  }

  RenderResult& result_;
  Crop crop_;
};

}  // namespace rt
