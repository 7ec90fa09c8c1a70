#pragma once
#include <cmath>
#include <vector>

namespace rt::test {

/// The rate of an error: error ~ N^slope, by least squares on logarithms.
struct Rate {
  double slope;
  double standard_error;  ///< from the residuals of the fit
};

inline Rate fit_rate(const std::vector<double>& counts, const std::vector<double>& errors) {
  const auto n = static_cast<double>(counts.size());
  double mx = 0;
  double my = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    mx += std::log(counts[i]) / n;
    my += std::log(errors[i]) / n;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double x = std::log(counts[i]) - mx;
    const double y = std::log(errors[i]) - my;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const double slope = xy / xx;
  return {slope, std::sqrt((yy - slope * xy) / (n - 2) / xx)};
}

}  // namespace rt::test
