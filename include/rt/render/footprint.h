#pragma once
/// How far apart neighbouring samples' rays are, from the camera through mirrors and glass. Kept
/// beside the rays, and only for scenes with textures (RenderPlan::footprints).
#include <optional>
#include <vector>

#include "rt/render/ray_differential.h"
#include "rt/render/shading.h"

namespace rt {

using RayDifferential = RayDifferentialOf<Vec3>;
using NormalDifferential = NormalDifferentialOf<Vec3>;

/// Distance between neighbouring samples in pixels: 1 / sqrt(n) for n samples a pixel. Adaptive
/// pixels count as four: what a sample stands for must not depend on what others saw, or their
/// scatter would be no measure of the error; and never so few that the blur of what they stand for
/// would show against max_error. The classic scheme counts its corners.
double sample_spacing(const RenderOptions& options);

/// Of a camera ray, whose direction is as CameraFrame gives it, not normalised. `spacing`: of samples.
template <class V>
RayDifferentialOf<V> camera_differential(const CameraFrame& camera, const RenderOptions& options,
                                         double spacing, const V& direction) {
  return {V(0.0), V(0.0), unit_change(direction, V(2.0 * spacing / options.width * camera.right)),
          unit_change(direction, V(2.0 * spacing / options.height * camera.down))};
}

/// Of a camera ray, not normalised, where the camera may move.
RayDifferential camera_differential(const RenderPlan& plan, double spacing, const TraceRay& ray);

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
  RayDifferential here_{};
  std::optional<NormalDifferential> normal_;  ///< there, once a path goes on
};

}  // namespace rt
