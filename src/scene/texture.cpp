#include "rt/scene/texture.h"

#include <cmath>

namespace rt {
namespace {

/// floor(x) modulo 2, without converting to an integer that may not hold it. Exact: halves and
/// floors of doubles are.
bool odd_cell(double x) {
  const double cell = std::floor(x);
  return cell != 2.0 * std::floor(0.5 * cell);
}

}  // namespace

Rgb colour(const Checker& checker, const Vec3& p_model) {
  const Vec3 q = p_model / checker.size;
  const bool odd = odd_cell(q.x) != (odd_cell(q.y) != odd_cell(q.z));
  return odd ? checker.odd : checker.even;
}

Rgb colour(const ImageTexture&, const Vec3&) { return Rgb(0.5); }

}  // namespace rt
