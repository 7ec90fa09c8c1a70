#pragma once
#include <cstdint>
#include <vector>

#include "rt/math/vec.h"

namespace rt {

/// The rectangle of the full picture that is rendered, in pixels.
struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};

/// A finished picture: linear RGB, row by row from the top.
struct Film {
  int width = 0;
  int height = 0;
  std::vector<float> pixels;  ///< 3 * width * height

  Film(int w, int h)
      : width(w),
        height(h),
        pixels(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  /// The three numbers of a pixel; those of the next to its right follow.
  float* at(int x, int y) {
    return &pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x))];
  }
  void set(int x, int y, const Rgb& value) {
    float* p = at(x, y);
    for (int k = 0; k < 3; ++k) {
      p[k] = static_cast<float>(value[k]);
    }
  }
};

}  // namespace rt
