#pragma once
/// Shapes that meet several rays at a time. Only what is decided by plain arithmetic is done here,
/// operation by operation as in the scalar functions of the same names; rays that are so near to
/// tangency, an edge or another surface that rounding decides are left to those.
#include "rt/geometry/shape.h"
#include "rt/math/wide.h"

namespace rt {

struct WideRay {
  Wide3 origin, direction;

  Ray lane(int i) const { return {origin.lane(i), direction.lane(i)}; }
};

/// What lanes cross, and where. Lanes that are undecided are in no way hits.
struct WideHit {
  WideMask hit;
  WideMask undecided;
  Wide t;
  Wide feature;
};

struct WideSurfacePoint {
  Wide3 position;
  Wide3 normal;  ///< also the one for shading
};

/// The first crossing with 0 < t <= t_max of rays that have not left this very shape.
/// `position_error`: as in RayStart; of all lanes zero, or of none.
WideHit intersect(const Sphere& shape, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error);
WideHit intersect(const Plane& shape, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error);
WideHit intersect(const Square& shape, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error);
WideHit intersect(const Box& shape, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error);
WideHit intersect(const Cylinder& shape, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error);
WideHit intersect(const Torus& shape, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error);

/// Where rays that start on the sphere, going inward, come out.
WideHit leave_inward(const Sphere& shape, const WideRay& ray, const Wide& t_max);

/// Lanes of rays that start on the torus, going outward, and plainly never meet it again.
WideMask leaves_for_good(const Torus& shape, const WideRay& ray);

WideSurfacePoint surface_point(const Sphere& shape, const WideRay& ray, const Wide& t,
                               const Wide& feature);
WideSurfacePoint surface_point(const Plane& shape, const WideRay& ray, const Wide& t,
                               const Wide& feature);
WideSurfacePoint surface_point(const Square& shape, const WideRay& ray, const Wide& t,
                               const Wide& feature);
WideSurfacePoint surface_point(const Box& shape, const WideRay& ray, const Wide& t,
                               const Wide& feature);
WideSurfacePoint surface_point(const Cylinder& shape, const WideRay& ray, const Wide& t,
                               const Wide& feature);
WideSurfacePoint surface_point(const Torus& shape, const WideRay& ray, const Wide& t,
                               const Wide& feature);

/// How the normals change over steps along the surface, to first order.
Wide3 normal_change(const Sphere& shape, const WideSurfacePoint& point, const Wide& feature,
                    const Wide3& step);
Wide3 normal_change(const Plane& shape, const WideSurfacePoint& point, const Wide& feature,
                    const Wide3& step);
Wide3 normal_change(const Square& shape, const WideSurfacePoint& point, const Wide& feature,
                    const Wide3& step);
Wide3 normal_change(const Box& shape, const WideSurfacePoint& point, const Wide& feature,
                    const Wide3& step);
Wide3 normal_change(const Cylinder& shape, const WideSurfacePoint& point, const Wide& feature,
                    const Wide3& step);
Wide3 normal_change(const Torus& shape, const WideSurfacePoint& point, const Wide& feature,
                    const Wide3& step);

/// The lanes whose rays plainly pass a triangle by, as most do that come near one. The others are for
/// intersect_triangle().
WideMask passes_by(const MeshData& mesh, std::uint32_t triangle, const WideRay& ray);

/// The lanes whose ray may cross what lies in the box, before t_max: no crossing that a shape's
/// scalar function would report is lost. `position_error`: as above; a ray that stands for one on
/// the surface may be taken to have gone in, though it passes the box by.
WideMask may_meet(const Bounds& box, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error);

/// The shapes that have these functions.
template <class S>
concept WideShape = requires(const S& shape, const WideRay& ray, const WideSurfacePoint& p,
                             const Wide& w) {
  intersect(shape, ray, w, w);
  surface_point(shape, ray, w, w);
  normal_change(shape, p, w, p.position);
};

}  // namespace rt
