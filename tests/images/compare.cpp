#include "compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::images {
namespace {

bool is_finite(const io::Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(),
                     [](float value) { return std::isfinite(value); });
}

Difference measure(const io::Image& a, const io::Image& b, double above) {
  Difference difference;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
    double worst = 0.0;
    for (std::size_t channel = i; channel < i + 3; ++channel) {
      const double apart = std::abs(double{a.pixels[channel]} - double{b.pixels[channel]});
      worst = std::max(worst, apart);
      sum += apart;
    }
    difference.max = std::max(difference.max, worst);
    difference.pixels += worst > 0.0 ? 1 : 0;
    difference.pixels_above += worst > above ? 1 : 0;
  }
  difference.mean = sum / static_cast<double>(std::max<std::size_t>(a.pixels.size(), 1));
  return difference;
}

}  // namespace

Verdict compare(const io::Image& a, const io::Image& b, const Tolerance& tolerance) {
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size()) {
    return {false, fmt::format("FAIL: {} x {} against {} x {} pixels", a.width, a.height, b.width,
                               b.height)};
  }
  if (!is_finite(a) || !is_finite(b)) {
    return {false, fmt::format("FAIL: NaN or infinity in the {} picture",
                               is_finite(a) ? "second" : "first")};
  }
  const Difference difference = measure(a, b, tolerance.above);
  std::string text =
      fmt::format("maximum {:.6g}, mean {:.6g}, {} of {} pixels differ", difference.max,
                  difference.mean, difference.pixels, a.pixels.size() / 3);
  const bool exact = !tolerance.max && !tolerance.mean && !tolerance.count;
  bool near_enough = true;
  // Written so that a NaN fails.
  const auto demand = [&](bool holds, const std::string& reason) {
    if (!holds) {
      near_enough = false;
      text += "\nFAIL: " + reason;
    }
  };
  if (exact) {
    demand(difference.max <= 0.0, "they must be equal");
  }
  if (tolerance.max) {
    demand(difference.max <= *tolerance.max,
           fmt::format("the maximum is above {:.6g}", *tolerance.max));
  }
  if (tolerance.mean) {
    demand(difference.mean <= *tolerance.mean,
           fmt::format("the mean is above {:.6g}", *tolerance.mean));
  }
  if (tolerance.count) {
    demand(difference.pixels_above <= *tolerance.count,
           fmt::format("{} pixels differ by more than {:.6g}, allowed are {}",
                       difference.pixels_above, tolerance.above, *tolerance.count));
  }
  return {near_enough, text};
}

}  // namespace rt::images
