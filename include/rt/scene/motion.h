#pragma once
/// How nodes move while the shutter is open. Time runs from 0 to 1.
#include <memory>
#include <vector>

#include "rt/math/transform.h"

namespace rt {

/// A scaling, then a rotation, both about the point `about`, then a translation.
struct Pose {
  Vec3 translate{0.0};
  Vec3 axis{0.0, 1.0, 0.0};  ///< of the rotation; any length but zero
  double degrees = 0.0;      ///< of the rotation; any number of turns
  Vec3 scale{1.0};
  Vec3 about{0.0};

  Affine affine() const;
};

/// The pose so far between two: all its numbers change evenly, so a rotation about one axis follows
/// its arc. A pose that is not turned takes the other's axis.
Pose between(const Pose& a, const Pose& b, double share);

struct MotionKey {
  double time;
  Pose pose;
};

/// A movement by keys of rising times, the first at 0, the last at 1.
struct Motion {
  std::vector<MotionKey> keys;

  Affine at(double time) const;
};

/// What a shape passes through: movements of nested nodes, with still transforms between.
struct MotionPath {
  /// Maps the space below to that above; the outermost comes first.
  struct Link {
    Affine fixed;                          ///< below the movement
    std::shared_ptr<const Motion> motion;  ///< null: none
  };
  std::vector<Link> links;

  Affine at(double time) const;
};

/// A copy of the path (none: null) with one more link at its inner end.
std::shared_ptr<const MotionPath> extended(const std::shared_ptr<const MotionPath>& path,
                                           MotionPath::Link link);

}  // namespace rt
