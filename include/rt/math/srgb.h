#pragma once
#include <array>

/// From linear light to the values that a screen is sent.

namespace rt {

/// The opto-electronic transfer function of IEC 61966-2-1 (sRGB), from [0,1] onto [0,1].
double srgb_oetf(double linear);

/// The same from a table, for estimates: clamped to [0,1], off by less than 1e-5, and monotone.
double srgb_displayed(double linear);

/// That table: its nodes are even in the square root of the value, where the curve is nearly
/// straight. The last stands twice, so that every node has a next.
inline constexpr int srgb_intervals = 1024;
using SrgbTable = std::array<float, srgb_intervals + 2>;
extern const SrgbTable srgb_table;

}  // namespace rt
