#include "rt/render/accel/box_group.h"

#include <algorithm>
#include <limits>

namespace rt {
namespace {

// How far the float test of a ray can be off, in units of the cube's half-edge, for origins up to
// BoxSpace::reach_of_rays = 8 from its centre and paths of up to 16:
//   the box's face, rounded to float                        2^-24
//   the origin, below 8, rounded                             2^-22
//   the direction's inverse, rounded: 2^-24 of the path      2^-20
//   the slab's difference and product: 2^-24 of the path,
//   each                                                     2^-19
//   moving and clipping the ray in double, from up to 2^27
//   half-edges away                                          2^-23
// All of it together is below 2^-18.
constexpr double slack = 0x1p-18;
// Shafts are far wider than this, which is more than their tests can be off: they begin and end
// within 5 `reach`, where each of the ten numbers in an inequality is rounded by less than 2^-18.
constexpr double shaft_slack = 0x1p-14;

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

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

using Floats = BoxGroup::Floats;

/// Narrows [enter, leave] to the s where p + q s <= 0.
void narrow(const Floats& p, float q, Floats& enter, Floats& leave) {
  const float safe = std::abs(q) > 1e-30F ? q : std::copysign(1e-30F, q);
  const Floats s = p * (-1.0F / safe);
  if (safe > 0.0F) {
    leave = min(leave, s);
  } else {
    enter = max(enter, s);
  }
}

}  // namespace

Bounds all_of(const std::vector<Bounds>& boxes) {
  Bounds all;
  for (const Bounds& b : boxes) {
    all.extend(b);
  }
  return all;
}

unsigned BoxGroup::touched(const BoxShaft& shaft) const {
  Floats enter = 0.0F;
  Floats leave = 1.0F;
  for (std::size_t k = 0; k < 3; ++k) {
    const float below = shaft.centre[k] - shaft.half[k];
    const float above = shaft.centre[k] + shaft.half[k];
    narrow(below - load(hi[k]), shaft.travel[k] - shaft.growth[k], enter, leave);
    narrow(load(lo[k]) - above, -(shaft.travel[k] + shaft.growth[k]), enter, leave);
  }
  return bits_of(enter <= leave);
}

BoxSpace::BoxSpace(const std::vector<Bounds>& boxes) : BoxSpace(all_of(boxes)) {}

BoxSpace::BoxSpace(const Bounds& all) {
  if (!all.empty()) {
    centre_ = all.centre();
    const double half_edge = 0.5 * max_abs(all.extent());
    per_unit_ = half_edge > 0.0 ? 1.0 / half_edge : 1.0;
  }
}

BoxSpace::Box BoxSpace::box(const Bounds& bounds) const {
  return {floats((bounds.lo - centre_) * per_unit_ - slack),
          floats((bounds.hi - centre_) * per_unit_ + slack)};
}

BoxSpace::Box BoxSpace::nothing() {
  constexpr auto away = static_cast<float>(4.0 * endless);
  return {{away, away, away}, {away, away, away}};
}

unsigned BoxSpace::filled(const BoxGroup& group) {
  return BoxGroup::bits_of(BoxGroup::load(group.lo[0]) < static_cast<float>(endless));
}

void BoxSpace::put(BoxGroup& group, std::size_t lane, const Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    group.lo[k][lane] = box.lo[k];
    group.hi[k][lane] = box.hi[k];
  }
}

bool BoxSpace::enter(const Ray& ray, double length, BoxRay& to) const {
  if (!(length > 0.0)) {
    return false;
  }
  const bool enters = enter({ray.origin, ray.direction * (1.0 / length)}, to);
  to.per_t *= length;
  return enters;
}

bool BoxSpace::enter(const Ray& ray, BoxRay& to) const {
  Vec3 origin = (ray.origin - centre_) * per_unit_;
  const Vec3& direction = ray.direction;
  Vec3 inverse;
  for (int k = 0; k < 3; ++k) {
    const double d = direction[k];
    inverse[k] = std::abs(d) * endless > 1.0 ? 1.0 / d : std::copysign(endless, d);
  }
  to.per_t = per_unit_;
  to.entry = 0.0;
  if (!(max_abs(origin) < reach_of_rays)) {
    if (!entry_into_cube(origin, inverse, to.entry)) {
      return false;
    }
    origin += to.entry * direction;
  }
  to.origin = floats(origin);
  to.inverse = floats(inverse);
  return true;
}

std::optional<BoxShaft> BoxSpace::enter(const Shaft& shaft) const {
  const Vec3 from = (shaft.from.centre() - centre_) * per_unit_;
  const Vec3 half = 0.5 * per_unit_ * shaft.from.extent() + shaft_slack;
  Vec3 travel = (shaft.to.centre() - centre_) * per_unit_ - from;
  Vec3 growth = 0.5 * per_unit_ * shaft.to.extent() + shaft_slack - half;
  constexpr double reach = shaft_reach;
  if (!(max_abs(from) < reach && max_abs(half) < 0.5 * reach)) {
    return {};
  }
  // A shaft to a far light is cut where nothing of it meets the boxes any more: at 4 reach along
  // the longest axis of its travel. From there on its centre is at least 4 s - 1 reach away from
  // theirs and its half-width, when it grows at most half as fast, at most 2 s + 1/2.
  const double length = max_abs(travel);
  if (length > 4.0 * reach && 2.0 * max_abs(growth) <= length) {
    const double share = 4.0 * reach / length;
    travel *= share;
    growth *= share;
  }
  if (!(max_abs(travel) <= 4.0 * reach && max_abs(growth) <= 4.0 * reach)) {
    return {};
  }
  return BoxShaft{floats(from), floats(travel), floats(half), floats(growth)};
}

}  // namespace rt
