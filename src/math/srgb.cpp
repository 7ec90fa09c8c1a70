#include "rt/math/srgb.h"

#include <array>
#include <cmath>

namespace rt {
namespace {

/// Nodes are even in the square root of the value, where the curve is nearly straight.
constexpr int intervals = 1024;

std::array<float, intervals + 1> make_table() {
  std::array<float, intervals + 1> table{};
  for (int i = 0; i <= intervals; ++i) {
    const double root = i / double{intervals};
    table[static_cast<std::size_t>(i)] = static_cast<float>(srgb_oetf(root * root));
  }
  return table;
}

const std::array<float, intervals + 1> table = make_table();

}  // namespace

double srgb_oetf(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double srgb_displayed(double linear) {
  if (!(linear > 0.0)) {
    return 0.0;
  }
  if (linear >= 1.0) {
    return 1.0;
  }
  const double position = intervals * std::sqrt(linear);
  const auto i = static_cast<std::size_t>(position);
  const double fraction = position - static_cast<double>(i);
  return table[i] + fraction * (double{table[i + 1]} - table[i]);
}

}  // namespace rt
