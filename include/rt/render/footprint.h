#pragma once
/// How far apart neighbouring samples' rays are, from the camera through mirrors and glass: ray
/// differentials (Igehy, "Tracing ray differentials", SIGGRAPH 1999). Kept beside the rays, and
/// only for scenes with textures (RenderPlan::footprints).
#include <vector>

#include "rt/render/shading.h"

namespace rt {

/// Changes of a ray from one sample to the next across and down the picture.
struct RayDifferential {
  Vec3 dp_dx{0.0}, dp_dy{0.0};  ///< of the origin; at a hit, of the point on the surface
  Vec3 dd_dx{0.0}, dd_dy{0.0};  ///< of the unit direction
};

/// Distance between neighbouring samples in pixels: 1 / sqrt(n) for n samples a pixel. Adaptive
/// pixels count as four: what a sample stands for must not depend on what others saw, or their
/// scatter would be no measure of the error; and never so few that the blur of what they stand for
/// would show against max_error. The classic scheme counts its corners.
double sample_spacing(const RenderOptions& options);

/// Of a camera ray, whose direction is as CameraFrame gives it, not normalised.
RayDifferential camera_differential(const CameraFrame& camera, const RenderOptions& options,
                                    const Vec3& direction);

/// Carried over a distance t along `direction` (unit) onto the plane through the hit.
RayDifferential arrived(const RayDifferential& ray, const Vec3& direction, double t,
                        const Vec3& normal);

/// A unit normal towards the ray, and its changes.
struct NormalDifferential {
  Vec3 normal;
  Vec3 dn_dx{0.0}, dn_dy{0.0};
};
RayDifferential reflected(const RayDifferential& at, const Vec3& direction,
                          const NormalDifferential& n);
/// eta: index before the surface over the index behind it. Where nothing is transmitted, `at`.
RayDifferential refracted(const RayDifferential& at, const Vec3& direction,
                          const NormalDifferential& n, double eta);
/// Of a direction drawn from a lobe about the perfect one: in any direction at least as wide as the
/// share of the lobe that one of the samples stands for.
RayDifferential widened(const RayDifferential& perfect, const Vec3& drawn,
                        const PowerCosineLobe& lobe, double spacing);

/// The shading normal of a point, and its changes over the steps `at.dp_dx`, `dp_dy`, those of
/// bumps left out.
NormalDifferential normal_differential(const RenderPlan& plan, const ShadingPoint& point,
                                       const RayDifferential& at);

/// The differentials of a tracer's open paths, in the order of its stack.
class FootprintTrail {
 public:
  explicit FootprintTrail(const RenderPlan& plan);

  /// A camera ray, not normalised, becomes the only open path.
  void begin(const TraceRay& camera_ray);
  /// The path that lies above `open` others meets a surface at a distance t.
  void arrive(std::size_t open, const TraceRay& ray, double t, ShadingPoint& point);
  /// At the surface just met.
  const RayDifferential& here() const { return here_; }
  /// A path goes on from there. `eta`: see refracted(); 1 where it goes straight on. `lobe`: the
  /// one `direction` was drawn from, or null.
  void branch(const ShadingPoint& point, const Vec3& incoming, const Vec3& direction, double eta,
              const PowerCosineLobe* lobe);

 private:
  const RenderPlan& plan_;
  double spacing_;
  std::vector<RayDifferential> open_;
  RayDifferential here_;
};

}  // namespace rt
