#pragma once
#include "rt/math/vec.h"

namespace rt {

/// A half-line. The direction need not have unit length: a ray keeps its parameter t when it is
/// carried into another space, so that hits of different instances compare directly.
struct Ray {
  Vec3 origin;
  Vec3 direction;

  Vec3 at(double t) const { return origin + t * direction; }
};

}  // namespace rt
