#pragma once
/// Bounds on rounding error, after Higham, "Accuracy and Stability of Numerical Algorithms", ch. 3.
#include <limits>

namespace rt {

/// Unit roundoff u of double precision: a correctly rounded operation errs by at most u relatively.
inline constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// gamma_n = n u / (1 - n u): bounds the relative error of a product or a sum of n rounded terms.
constexpr double gamma(int n) { return n * unit_roundoff / (1 - n * unit_roundoff); }

/// What boxes are enlarged by, of the size of what was added up: a few products and sums, each
/// correctly rounded, and the error of the inverse map that carries a ray or a point to the shape (at
/// most 48 roundings: placement_table.h).
inline constexpr double rounding_of_maps = gamma(64);

}  // namespace rt
