#include "rt/scene/texture.h"

#include <cmath>
#include <limits>

#include "rt/math/rounding.h"

namespace rt {
namespace {

/// +1 in even cells, -1 in odd ones. Without converting to an integer that may not hold the cell;
/// exact: halves and floors of doubles are.
double sign_of_cell(double cell) { return cell == 2.0 * std::floor(0.5 * cell) ? 1.0 : -1.0; }

/// Mean of sign_of_cell(floor(t)) over a width about x. Its integral from an even cell's begin is a
/// triangle wave between 0 and 1; counted from the cell of the lower end, so that nothing grows
/// with x.
double wave(double x, double width) {
  if (width > std::numeric_limits<double>::max()) {
    return 0.0;
  }
  const double lo = x - 0.5 * width;
  const double cell = std::floor(lo);
  const double sign = sign_of_cell(cell);
  const double begin = lo - cell;    // in [0, 1)
  const double end = begin + width;  // of the same stretch
  if (!(end > 1.0)) {
    return sign;
  }
  const double phase = end - 2.0 * std::floor(0.5 * end);  // in [0, 2)
  const double integral = 1.0 - std::abs(phase - 1.0);
  return sign * (integral - begin) / width;
}

}  // namespace

Rgb colour(const Checker& checker, const Vec3& p_model, const Vec3& width) {
  // A surface point is good to a few roundings of its coordinates, and the quotient rounds once
  // more; gamma(16) is the bound that shading points give.
  const Vec3 q = p_model / checker.size;
  const Vec3 lifted = q + gamma(17) * max_abs(q);
  const Vec3 w = width / checker.size;
  const double even = 0.5 + 0.5 * wave(lifted.x, w.x) * wave(lifted.y, w.y) * wave(lifted.z, w.z);
  return even * checker.even + (1.0 - even) * checker.odd;
}

}  // namespace rt
