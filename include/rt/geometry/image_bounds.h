#pragma once
/// Boxes about shapes that a map has carried away. The box of a box is easily had, but half as large
/// again as it need be in each direction for a ball that is turned.
#include "rt/geometry/shape.h"
#include "rt/math/transform.h"

namespace rt {

/// A disc about the y axis, a ball and a stretch of the y axis, added up as Minkowski does: all points
/// that are a sum of one of each.
struct RoundHull {
  Vec3 centre{0.0};
  double disc = 0.0;  ///< radius
  double ball = 0.0;  ///< radius
  double half = 0.0;  ///< of the stretch's length
};

/// The smallest box that holds the image, rounded outward as transformed() does.
Bounds image_bounds(const Affine& map, const RoundHull& hull);

/// A box that holds the image of a shape; of a mesh, asks all its triangles.
template <class S>
Bounds image_bounds(const Affine& map, const S& shape) {
  return transformed(map, bounds(shape));
}
inline Bounds image_bounds(const Affine& map, const Sphere& s) {
  return image_bounds(map, RoundHull{.centre = s.centre, .ball = s.radius});
}
inline Bounds image_bounds(const Affine& map, const Torus& s) {
  return image_bounds(map, RoundHull{.disc = s.major_radius, .ball = s.minor_radius});
}
inline Bounds image_bounds(const Affine& map, const Cylinder&) {
  return image_bounds(map, RoundHull{.centre = {0.0, 0.5, 0.0}, .disc = 1.0, .half = 0.5});
}
inline Bounds image_bounds(const Affine& map, const Capsule& s) {
  const double half = 0.5 * s.length;
  return image_bounds(map, RoundHull{.centre = {0.0, half, 0.0}, .ball = s.radius, .half = half});
}

}  // namespace rt
