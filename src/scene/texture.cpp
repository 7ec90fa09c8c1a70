#include "rt/scene/texture.h"

#include <cmath>

namespace rt {
namespace {

/// floor(x) modulo 2, without converting to an integer that may not hold it.
bool odd_cell(double x) { return std::fmod(std::floor(x), 2.0) != 0.0; }

}  // namespace

Rgb colour(const Checker& checker, const Vec3& p_model) {
  const Vec3 q = p_model / checker.size;
  const bool odd = odd_cell(q.x) != (odd_cell(q.y) != odd_cell(q.z));
  return odd ? checker.odd : checker.even;
}

}  // namespace rt
