#include "rt/render/estimate.h"

#include <algorithm>
#include <cmath>

#include "rt/math/wide_srgb.h"

namespace rt {
namespace {

// What is no number is nothing to the screen.
double clipped(double v) { return v > 0.0 ? std::min(v, 1.0) : 0.0; }
Wide clipped(const Wide& v) { return min(max(Wide(0.0), v), Wide(1.0)); }

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

}  // namespace rt
