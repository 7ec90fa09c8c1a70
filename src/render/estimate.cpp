#include "rt/render/estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "rt/math/wide_srgb.h"

namespace rt {
namespace {

/// The claimed error is so many standard deviations: chosen such that 95% of true errors lie below
/// 1.5 times the claim (bench/results/calibration.md).
constexpr double claim = 1.3;

/// What the estimate before a doubling counts against each of the two that come with it.
constexpr double memory = 2.0;

constexpr double max_exponent = 1.5;

/// The contrast, of few samples, counts so many times.
constexpr double caution = 2.0;

/// Of a pixel's number of samples, a power of two.
double log2_of(std::uint32_t count) { return std::countr_zero(count); }

/// n^-max_exponent.
double fastest(double n) { return 1.0 / (n * std::sqrt(n)); }

// What is no number is nothing to the screen.
double clipped(double v) { return v > 0.0 ? std::min(v, 1.0) : 0.0; }
Wide clipped(const Wide& v) { return min(max(Wide(0.0), v), Wide(1.0)); }

/// The variance of one sample, from those taken.
Rgb variance_of_samples(const PixelEstimate& e) {
  const Rgb mean = e.mean();
  return glm::max(e.squares / std::max(1.0 * (e.count - e.bad), 1.0) - mean * mean, Rgb(0.0));
}

/// How fast the variance of the mean has fallen, from one sample to half of those taken by now.
double observed_exponent(const PixelEstimate& e, const Rgb& sample) {
  const double of_samples = sample.r + sample.g + sample.b;
  const double of_mean = e.variance.r + e.variance.g + e.variance.b;
  if (!(of_samples > 0.0 && of_mean > 0.0)) {
    return max_exponent;
  }
  return std::clamp(std::log2(of_samples / of_mean) / (log2_of(e.count) - 1.0), 1.0, max_exponent);
}

void set_error(PixelEstimate& e, Encoding encoding) {
  e.error = static_cast<float>(displayed_error(e.mean(), claim * glm::sqrt(e.variance), encoding));
}

/// What of the contrast the mean of so many pilots has.
double share_of_contrast(std::uint32_t pilots) { return caution * fastest(pilots); }

}  // namespace

Rgb PixelEstimate::mean() const {
  const std::uint32_t good = count - bad;
  return good > 0 ? (quarters[0] + quarters[1] + quarters[2] + quarters[3]) / double{1.0 * good}
                  : Rgb(0.0);
}

// With V(n) the variance of n samples' mean, the quarters' scatter s^2 = sum (q - mean)^2 / 3 has
// the expectation 4/3 (V(n/4) - V(n)), whatever their correlation; V(n) = f V(n/4) gives V(n).
Rgb variance_of_quarters(const PixelEstimate& e, double exponent) {
  const double f = std::exp2(-2.0 * exponent);
  const double per_quarter = 4.0 / e.count;
  const Rgb mean =
      0.25 * per_quarter * (e.quarters[0] + e.quarters[1] + e.quarters[2] + e.quarters[3]);
  Rgb sum(0.0);
  for (const Rgb& quarter : e.quarters) {
    const Rgb d = per_quarter * quarter - mean;
    sum += d * d;
  }
  return sum / 3.0 * (0.75 * f / (1.0 - f));
}

double displayed_error(const Rgb& mean, const Rgb& s, Encoding encoding) {
  double largest = 0.0;
  for (int k = 0; k < 3; ++k) {
    if (s[k] == 0.0) {
      continue;
    }
    const double lo = mean[k] - s[k];
    const double hi = mean[k] + s[k];
    const double shown = encoding == Encoding::srgb
                             ? srgb_displayed(hi) - srgb_displayed(lo)
                             : clipped(hi) - clipped(lo);
    largest = std::max(largest, 0.5 * shown);
  }
  return largest;
}

Wide displayed_error(const Wide3& mean, const Wide3& s, Encoding encoding) {
  const auto shown = [encoding](const Wide& m, const Wide& by) {
    const Wide lo = m - by;
    const Wide hi = m + by;
    return encoding == Encoding::srgb
               ? srgb_displayed(hi) - srgb_displayed(lo)
               : clipped(hi) - clipped(lo);
  };
  const Wide largest = max(max(shown(mean.x, s.x), shown(mean.y, s.y)), shown(mean.z, s.z));
  return 0.5 * max(Wide(0.0), largest);
}

void count_in(PixelEstimate& e, std::span<const std::optional<Rgb>> values, std::uint32_t count) {
  if (e.count >= 4) {
    e.quarters = {e.quarters[0] + e.quarters[1], e.quarters[2] + e.quarters[3], Rgb(0.0), Rgb(0.0)};
  }
  const std::uint32_t quarter = std::max(count / 4, 1u);
  for (std::uint32_t q = e.count / quarter; !values.empty(); ++q) {
    const auto next = values.first(std::min<std::size_t>(quarter, values.size()));
    for (const auto& value : next) {
      if (value) {
        e.quarters[q] += *value;
        e.squares += *value * *value;
      } else {
        ++e.bad;
      }
    }
    e.count += static_cast<std::uint32_t>(next.size());
    values = values.subspan(next.size());
  }
}

void estimate_doubled(PixelEstimate& e, Encoding encoding) {
  const Rgb sample = variance_of_samples(e);
  const double rate = observed_exponent(e, sample);
  const double between = 0.5 * (rate + max_exponent);
  e.variance = (memory * std::exp2(-rate) * e.variance + variance_of_quarters(e, rate) +
                std::exp2(-between * log2_of(e.count)) * sample) /
               (memory + 2.0);
  set_error(e, encoding);
}

void estimate_thin(PixelEstimate& e, const Rgb& contrast, Encoding encoding) {
  e.variance = (fastest(e.count) * (contrast + variance_of_samples(e)) +
                variance_of_quarters(e, 0.5 * (1.0 + max_exponent))) /
               3.0;
  set_error(e, encoding);
}

Rgb variance_of_pilots(const Rgb& contrast, std::uint32_t pilots) {
  return share_of_contrast(pilots) * contrast;
}

Wide estimated_error(const Wide3& mean, const Wide3& contrast, std::uint32_t pilots,
                     Encoding encoding) {
  const Wide3 variance = share_of_contrast(pilots) * contrast;
  const Wide3 deviation(sqrt(variance.x), sqrt(variance.y), sqrt(variance.z));
  return displayed_error(mean, claim * deviation, encoding);
}

}  // namespace rt
