#include "z_test.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rt::images {
namespace {

// A float picture's mean over seeds is itself rounded to float.
constexpr double float_rounding = 0x1p-22;
constexpr double surprising = 6.0;
constexpr double allowed_deviation = 4.0;

bool same_size(const io::Image& a, const io::Image& b) {
  return a.width == b.width && a.height == b.height && a.pixels.size() == b.pixels.size();
}

/// Sums over the values of one channel.
struct Sums {
  double n = 0, z = 0, z2 = 0, z4 = 0;

  void add(double value) {
    const double square = value * value;
    n += 1;
    z += value;
    z2 += square;
    z4 += square * square;
  }
  /// The mean of z in its standard deviations.
  double bias() const { return z / std::sqrt(n); }
  /// The mean of z^2 less what is expected, in its standard deviations.
  double spread(double expected) const {
    const double mean = z2 / n;
    return (mean - expected) / std::sqrt((z4 / n - mean * mean) / n);
  }
};

}  // namespace

Reference reference_of(const std::vector<io::Image>& pictures) {
  if (pictures.size() < 2) {
    throw std::invalid_argument("a reference takes at least two pictures");
  }
  Reference r{pictures[0], pictures[0]};
  const auto n = static_cast<double>(pictures.size());
  for (std::size_t i = 0; i < r.mean.pixels.size(); ++i) {
    double sum = 0.0;
    for (const io::Image& p : pictures) {
      if (!same_size(p, r.mean)) {
        throw std::invalid_argument("the pictures differ in size");
      }
      sum += p.pixels[i];
    }
    double squares = 0.0;
    for (const io::Image& p : pictures) {
      squares += (p.pixels[i] - sum / n) * (p.pixels[i] - sum / n);
    }
    r.mean.pixels[i] = static_cast<float>(sum / n);
    r.variance.pixels[i] = static_cast<float>(squares / (n - 1));
  }
  return r;
}

ZVerdict z_test(const io::Image& picture, const Reference& reference, int count) {
  if (!same_size(picture, reference.mean) || !same_size(picture, reference.variance)) {
    return {false, "FAIL: the pictures differ in size"};
  }
  Sums sums[3];
  double surprises = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const double mean = reference.mean.pixels[i];
    const double apart = picture.pixels[i] - mean;
    const double deviation = std::sqrt(reference.variance.pixels[i] * (1.0 + 1.0 / count));
    // Where only rounding varies, nothing is random.
    const double rounding = float_rounding * std::abs(mean);
    if (!(std::abs(apart) <= surprising * deviation + rounding)) {  // NaN surprises
      ++surprises;
    } else if (deviation > rounding) {
      sums[i % 3].add(apart / deviation);
    }
  }
  ZVerdict verdict{true, ""};
  const double allowed = static_cast<double>(picture.pixels.size()) / (std::numbers::e * count);
  const auto demand = [&](const std::string& what, double value, double limit) {
    const bool holds = value <= limit;  // NaN fails
    verdict.fair = verdict.fair && holds;
    verdict.text +=
        fmt::format("{}{} {:.2f} (at most {:.2f})\n", holds ? "" : "FAIL: ", what, value, limit);
  };
  demand("surprises", surprises, allowed);
  const double nu = count - 1;
  for (int k = 0; k < 3; ++k) {
    demand(fmt::format("channel {}: bias of {} random values", k, sums[k].n),
           std::abs(sums[k].bias()), allowed_deviation);
    demand(fmt::format("channel {}: excess of z^2", k), sums[k].spread(nu / (nu - 2)),
           allowed_deviation);
  }
  return verdict;
}

}  // namespace rt::images
