#include "rt/render/placement.h"

#include <algorithm>
#include <cmath>

#include "rt/math/rounding.h"

namespace rt {
namespace {

/// Keys are doubled until they are dense enough, but not beyond this many intervals: what turns so
/// fast is a blur in any picture.
constexpr std::size_t most_intervals = 4096;

Affine mixed(const Affine& a, const Affine& b, double share) {
  return {a.linear * (1.0 - share) + b.linear * share, glm::mix(a.offset, b.offset, share)};
}

Vec3 corner(const Bounds& box, int i) {
  return {(i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
          (i & 4) != 0 ? box.hi.z : box.lo.z};
}

/// How far the straight way between two keys is off the true place at a share of it, relative to
/// the distance from the eye.
double deviation(const Affine& a, const Affine& truth, const Affine& b, double share,
                 const Bounds& box) {
  const Affine chord = mixed(a, b, share);
  double largest = 0.0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 there = truth.point(corner(box, i));
    largest =
        std::max(largest, glm::length(chord.point(corner(box, i)) - there) / glm::length(there));
  }
  return largest;
}

}  // namespace

Placement::Placement(const Affine& to_render, const Affine& to_model)
    : render_from_model(to_render),
      model_from_render(to_model),
      moved_only(to_render.linear == Mat3(1.0) && to_model.linear == Mat3(1.0)),
      model_per_render(norm(to_model.linear)),
      render_per_model(norm(to_render.linear)) {}

Placement PlannedMotion::at(double time) const {
  const double position = time * static_cast<double>(keys.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(position), keys.size() - 2);
  const Affine there = mixed(keys[i], keys[i + 1], position - static_cast<double>(i));
  const Mat3 back = glm::inverse(there.linear);
  return {there, {back, -(back * there.offset)}};
}

Bounds PlannedMotion::bounds(const Bounds& model_box) const {
  Bounds all;
  for (const Affine& key : keys) {
    all.extend(transformed(key, model_box));
  }
  // The mean of two keys is off by three roundings of each.
  const double slack = gamma(6) * std::max(max_abs(all.lo), max_abs(all.hi));
  return {all.lo - slack, all.hi + slack};
}

PlannedMotion planned_motion(const std::function<Affine(double)>& path, const Bounds& model_box,
                             double tolerance) {
  // What has no end is judged by its part about its own origin.
  const Bounds box = model_box.finite() ? model_box : Bounds{Vec3(-1.0), Vec3(1.0)};
  // Three intervals at first, so that a full turn does not look still. Each is looked at halfway
  // and in the golden section: no whole number of turns hides at both.
  constexpr double golden = 0.3819660112501051;
  PlannedMotion motion{{path(0.0), path(1.0 / 3.0), path(2.0 / 3.0), path(1.0)}};
  for (bool dense = false; !dense && 2 * (motion.keys.size() - 1) <= most_intervals;) {
    const auto intervals = static_cast<double>(2 * (motion.keys.size() - 1));
    std::vector<Affine> finer{motion.keys[0]};
    dense = true;
    for (std::size_t i = 0; i + 1 < motion.keys.size(); ++i) {
      finer.push_back(path((2.0 * static_cast<double>(i) + 1.0) / intervals));
      finer.push_back(motion.keys[i + 1]);
      const Affine aside = path(2.0 * (static_cast<double>(i) + golden) / intervals);
      const Affine& middle = finer[finer.size() - 2];
      dense = dense &&
              deviation(motion.keys[i], middle, motion.keys[i + 1], 0.5, box) <= tolerance &&
              deviation(motion.keys[i], aside, motion.keys[i + 1], golden, box) <= tolerance;
    }
    if (!dense) {
      motion.keys = std::move(finer);
    }
  }
  return motion;
}

}  // namespace rt
