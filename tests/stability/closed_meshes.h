#pragma once
/// Solids made of triangles that face outward, for rays that leave a surface.
#include "rt/geometry/mesh.h"

namespace rt::stability {

/// The box [-1, 1]^3, two triangles a face.
Mesh box_mesh();
/// The unit sphere: an octahedron's faces cut into 4^cuts triangles each, about the origin.
Mesh sphere_mesh(int cuts);
/// A ring of radius 1 about the y axis with a tube of radius 0.4: `along` pieces of `around` sides.
Mesh torus_mesh(int along, int around);

}  // namespace rt::stability
