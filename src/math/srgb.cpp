#include "rt/math/srgb.h"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

SrgbTable make_table() {
  SrgbTable table{};
  for (int i = 0; i <= srgb_intervals; ++i) {
    const double root = i / double{srgb_intervals};
    table[static_cast<std::size_t>(i)] = static_cast<float>(srgb_oetf(root * root));
  }
  table.back() = 1.0F;
  return table;
}

}  // namespace

const SrgbTable srgb_table = make_table();

double srgb_oetf(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double srgb_displayed(double linear) {
  const double position = srgb_intervals * std::sqrt(linear > 0.0 ? std::min(linear, 1.0) : 0.0);
  const auto i = static_cast<std::size_t>(position);
  const double low = double{srgb_table[i]};
  return low + (position - static_cast<double>(i)) * (double{srgb_table[i + 1]} - low);
}

}  // namespace rt
