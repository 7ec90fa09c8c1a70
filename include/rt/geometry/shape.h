#pragma once
/// The closed list of shapes. To add one: write its header (a plain struct and the five functions
/// below) beside the others, and add it to the variant and to the table after it.
///
///   OptionalHit intersect(const S&, const Ray&, double t_max, const RayStart&)
///       The nearest crossing with 0 < t <= t_max, or none. Any NaN in what it looks at gives none.
///   SurfacePoint surface_point(const S&, const Ray&, const ShapeHit&)
///       The hit refined onto the surface, and the normals there.
///   SurfaceCoordinates surface_coordinates(const S&, const SurfacePoint&, std::uint32_t feature)
///       Only evaluated for textured surfaces. Derivatives are those of one smooth sheet: they do
///       not jump where u wraps. dp_du is 0 at a pole.
///   Vec3 normal_change(const S&, const SurfacePoint&, std::uint32_t feature, const Vec3& step)
///       How the shading normal changes over a step along the surface, to first order. Only
///       evaluated where rays have differentials.
///   Bounds bounds(const S&)
///       A box that holds the shape; infinite where the shape is.
#include <array>
#include <variant>

#include "rt/geometry/blob.h"
#include "rt/geometry/box.h"
#include "rt/geometry/capsule.h"
#include "rt/geometry/cone.h"
#include "rt/geometry/cylinder.h"
#include "rt/geometry/mesh.h"
#include "rt/geometry/plane.h"
#include "rt/geometry/sphere.h"
#include "rt/geometry/torus.h"

namespace rt {

using Shape =
    std::variant<Sphere, Box, Plane, Square, Cylinder, PointedCone, Capsule, Torus, Blob, Mesh>;

/// What is known of a kind of shape without looking at one.
struct ShapeTraits {
  const char* kind;  ///< its name in scripts and messages
  bool convex;       ///< whether no line crosses its surface more than twice
};

/// In the order of the variant.
inline constexpr std::array shape_traits{ShapeTraits{"sphere", true},   ShapeTraits{"box", true},
                                         ShapeTraits{"plane", true},    ShapeTraits{"square", true},
                                         ShapeTraits{"cylinder", true}, ShapeTraits{"cone", true},
                                         ShapeTraits{"capsule", true},  ShapeTraits{"torus", false},
                                         ShapeTraits{"blob", true},     ShapeTraits{"mesh", false}};
static_assert(shape_traits.size() == std::variant_size_v<Shape>);

inline const char* shape_kind(const Shape& shape) { return shape_traits[shape.index()].kind; }
inline bool convex(const Shape& shape) { return shape_traits[shape.index()].convex; }

}  // namespace rt
