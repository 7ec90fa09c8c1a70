#include "rt/render/accel/box_list.h"

#include <algorithm>
#include <limits>

namespace rt {
namespace {

// How far the float test can be off, in units of the cube's half-edge, for origins up to `reach` =
// 8 from its centre and paths of up to 16:
//   the box's face, rounded to float                        2^-24
//   the origin, below 8, rounded                             2^-22
//   the direction's inverse, rounded: 2^-24 of the path      2^-20
//   the slab's difference and product: 2^-24 of the path,
//   each                                                     2^-19
//   moving and clipping the ray in double, from up to 2^27
//   half-edges away                                          2^-23
// All of it together is below 2^-18.
constexpr double slack = 0x1p-18;
constexpr double reach = 8.0;
// Stands for 1/0: no path is so long.
constexpr double endless = 1e30;

/// Where the ray enters a cube that holds all enlarged boxes; false when it passes by.
bool entry_into_cube(const Vec3& origin, const Vec3& inverse, double& entry) {
  constexpr double cube = 1.0 + 0x1p-10;
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double a = (-cube - origin[k]) * inverse[k];
    const double b = (cube - origin[k]) * inverse[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  entry = enter;
  return enter <= leave;
}

}  // namespace

BoxList::BoxList(const std::vector<Bounds>& boxes) {
  Bounds all;
  for (const Bounds& b : boxes) {
    all.extend(b);
  }
  if (!boxes.empty()) {
    centre_ = all.centre();
    const double half_edge = 0.5 * max_abs(all.extent());
    per_unit_ = half_edge > 0.0 ? 1.0 / half_edge : 1.0;
  }
  groups_.resize((boxes.size() + width - 1) / width);
  for (std::size_t i = 0; i < width * groups_.size(); ++i) {
    Group& group = groups_[i / width];
    for (int k = 0; k < 3; ++k) {
      // Lanes without a box get one that nothing touches.
      const bool used = i < boxes.size();
      const double lo = used ? (boxes[i].lo[k] - centre_[k]) * per_unit_ - slack : 4.0 * endless;
      const double hi = used ? (boxes[i].hi[k] - centre_[k]) * per_unit_ + slack : 4.0 * endless;
      group.lo[k][i % width] = static_cast<float>(lo);
      group.hi[k][i % width] = static_cast<float>(hi);
    }
  }
}

bool BoxList::prepare(const Ray& ray, Prepared& p) const {
  Vec3 origin = (ray.origin - centre_) * per_unit_;
  Vec3 inverse;
  for (int k = 0; k < 3; ++k) {
    const double d = ray.direction[k];
    inverse[k] = std::abs(d) * endless > 1.0 ? 1.0 / d : std::copysign(endless, d);
  }
  p.per_t = per_unit_;
  if (!(max_abs(origin) < reach)) {
    if (!entry_into_cube(origin, inverse, p.entry)) {
      return false;
    }
    origin += p.entry * ray.direction;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    p.origin[k] = static_cast<float>(origin[static_cast<int>(k)]);
    p.inverse[k] = static_cast<float>(inverse[static_cast<int>(k)]);
  }
  return true;
}

}  // namespace rt
