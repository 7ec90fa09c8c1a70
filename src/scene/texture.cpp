#include "rt/scene/texture.h"

#include <cmath>
#include <limits>

#include "rt/math/rounding.h"
#include "rt/scene/wide_texture.h"

namespace rt {
namespace {

/// +1 in even cells, -1 in odd ones. Without converting to an integer that may not hold the cell;
/// exact: halves and floors of doubles are.
template <class Real>
Real sign_of_cell(const Real& cell) {
  using std::floor;
  return select(cell == 2.0 * floor(0.5 * cell), Real(1.0), Real(-1.0));
}

/// Mean of sign_of_cell(floor(t)) over a width about x. Its integral from an even cell's begin is a
/// triangle wave between 0 and 1; counted from the cell of the lower end, so that nothing grows
/// with x.
template <class Real>
Real wave(const Real& x, const Real& width) {
  using std::abs, std::floor;
  const Real lo = x - 0.5 * width;
  const Real cell = floor(lo);
  const Real sign = sign_of_cell(cell);
  const Real begin = lo - cell;    // in [0, 1)
  const Real end = begin + width;  // of the same stretch
  const Real phase = end - 2.0 * floor(0.5 * end);  // in [0, 2)
  const Real integral = 1.0 - abs(phase - 1.0);
  const Real mean = select(end > 1.0, sign * (integral - begin) / width, sign);
  return select(width > std::numeric_limits<double>::max(), Real(0.0), mean);
}

// A surface point is good to a few roundings of its coordinates, and the quotient rounds once more;
// gamma(16) is the bound that shading points give.
template <class Real, class V>
Real share_of_even(const V& q, const V& width) {
  const Real lift = gamma(17) * max_abs(q);
  return 0.5 + 0.5 * wave<Real>(q.x + lift, width.x) * wave<Real>(q.y + lift, width.y) *
                   wave<Real>(q.z + lift, width.z);
}

}  // namespace

Rgb colour(const Checker& checker, const Vec3& p_model, const Vec3& width) {
  const double even = share_of_even<double>(p_model / checker.size, width / checker.size);
  return even * checker.even + (1.0 - even) * checker.odd;
}

Wide3 colour(const Checker& checker, const Wide3& p_model, const Wide3& width) {
  const Wide even =
      share_of_even<Wide>(p_model / Wide(checker.size), width / Wide(checker.size));
  return even * Wide3(checker.even) + (1.0 - even) * Wide3(checker.odd);
}

}  // namespace rt
