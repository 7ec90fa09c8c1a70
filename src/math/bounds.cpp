#include "rt/math/bounds.h"

#include <cmath>

#include "rt/math/rounding.h"

namespace rt {

bool Bounds::empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }

bool Bounds::finite() const { return all_finite(lo) && all_finite(hi); }

void Bounds::extend(const Vec3& p) {
  lo = glm::min(lo, p);
  hi = glm::max(hi, p);
}

void Bounds::extend(const Bounds& b) {
  lo = glm::min(lo, b.lo);
  hi = glm::max(hi, b.hi);
}

Bounds transformed(const Affine& a, const Bounds& b) {
  if (b.empty()) {
    return b;
  }
  if (!b.finite()) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {Vec3(-inf), Vec3(inf)};
  }
  Bounds out;
  for (int row = 0; row < 3; ++row) {
    double lo = a.offset[row];
    double hi = lo;
    double magnitude = std::abs(lo);
    for (int column = 0; column < 3; ++column) {
      const double e = a.linear[column][row] * b.lo[column];
      const double f = a.linear[column][row] * b.hi[column];
      lo += std::min(e, f);
      hi += std::max(e, f);
      magnitude += std::max(std::abs(e), std::abs(f));
    }
    const double slack = rounding_of_maps * magnitude;
    out.lo[row] = lo - slack;
    out.hi[row] = hi + slack;
  }
  return out;
}

}  // namespace rt
