#pragma once
/// What rays and shapes tell each other. Everything here is in the shape's own model space.
#include <cstdint>
#include <optional>

#include "rt/math/ray.h"

namespace rt {

/// To which side of a surface a ray leaves it: sign(normal . direction).
enum class Leaving : std::int8_t { inward = -1, nothing = 0, outward = 1 };

/// What is known of a ray's origin. There is no epsilon in t: a ray that starts on a surface says
/// so, and the shape finds the next root by analysis.
struct RayStart {
  /// Set when the ray starts on this very shape (for a mesh: on triangle `feature`). The origin is
  /// then taken to lie on the surface exactly, and the crossing at t = 0 is not a hit.
  Leaving leaving = Leaving::nothing;
  /// The ShapeHit::feature that was left; meaningless unless `leaving` is set.
  std::uint32_t feature = 0;
  /// The origin's distance from the point it stands for is at most this. A shape (other than the
  /// one left) whose surface passes within that distance of the origin coincides with the surface
  /// left, as far as arithmetic can tell, and is treated as left too, to the side of sign(n .
  /// direction). Zero for rays that start at a camera: nothing then counts as left.
  double position_error = 0;
};

/// A crossing of a surface at ray parameter t.
struct ShapeHit {
  double t;
  /// Which part of the shape: a box face, a cylinder's cap, a mesh's triangle. Each shape says
  /// what.
  std::uint32_t feature = 0;
};

using OptionalHit = std::optional<ShapeHit>;

/// A point of a surface: refined onto it, with the unit normal that points out of the solid.
struct SurfacePoint {
  Vec3 position;
  /// Geometric normal, unit length.
  Vec3 normal;
  /// Normal for shading: differs from `normal` only on meshes with vertex normals.
  Vec3 shading_normal;
};

/// Surface coordinates at a point; u, v in [0,1] where the shape is bounded.
struct SurfaceCoordinates {
  Vec2 uv;
  Vec3 dp_du;
  Vec3 dp_dv;
};

}  // namespace rt
