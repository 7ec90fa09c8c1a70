#pragma once
/// What of a fan of rays a shape stops.
///
/// A plane through a point cuts a convex shape in a convex piece; seen from the point it fills one
/// interval of the directions in that plane. Its ends are known in closed form: lines from the
/// point touch a conic, or pass a corner. Where rays towards the points of a line on a light would
/// have to find out by trial how much of it is hidden, the interval says it exactly.
#include <optional>

#include "rt/geometry/shape.h"

namespace rt {

/// The rays origin + t (start + s step), t > 0, for all s.
struct Fan {
  Vec3 origin;
  Vec3 start, step;
  /// What may lie nearer than this, in t, is too near for its direction to be known: the origin's
  /// own error, and that of what is compared with it.
  double nearest = 0.0;
};

/// The values of s in (lo, hi); none when lo >= hi.
struct Span {
  double lo, hi;
};

/// The s whose rays meet the shape; ends may be infinite. Empty where no formula tells: for shapes
/// that are not convex, for planes and capsules, and from inside or as near as `nearest`. Then rays
/// must.
std::optional<Span> stopped(const Shape& shape, const Fan& fan);

}  // namespace rt
