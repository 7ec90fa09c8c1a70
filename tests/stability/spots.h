#pragma once
#include "stability/families.h"

namespace rt::stability {

/// The unit cylinder, cone, blob, plane, a square, one of a few capsules or of a few triangles.
Shape fixed_shape(const std::string& name, Random& random);

/// R of a torus, the radius of a sphere, 1 for what has a size of the order of one.
double size_of(const Shape& shape);

/// A point well inside a solid.
Vec3 inner_point(const Shape& shape, Random& random);

/// A ray past an edge, a rim or the blob's join.
Ray past_an_edge(const Shape& shape, Random& random);

}  // namespace rt::stability
