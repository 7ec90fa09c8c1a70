#pragma once
/// Points to be shaded, and rays from them.
#include <cstdint>

#include "rt/render/plan.h"
#include "rt/render/trace.h"

namespace rt {

/// Rays traced, by kind.
struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t shadow = 0;
  std::uint64_t reflection = 0;
  std::uint64_t refraction = 0;

  std::uint64_t total() const { return camera + shadow + reflection + refraction; }
  RayCounts& operator+=(const RayCounts& other);
};

/// A hit in render space, with all that shading needs.
struct ShadingPoint {
  Vec3 position;
  Vec3 normal;          ///< geometric, unit, towards the side the ray came from
  Vec3 shading_normal;  ///< likewise
  /// sign(outward normal . normal): which side of the surface the ray came from.
  Leaving side;
  double position_error;  ///< distance to the true surface point is at most this
  std::uint32_t instance;
  std::uint32_t feature;
  double time;  ///< of the ray that found it
  /// Distance on the surface between neighbouring samples; 0 where nobody asks (no textures).
  double footprint = 0.0;
};

/// The hit in the instance's model space, refined onto the surface.
SurfacePoint model_point(const RenderPlan& plan, const TraceRay& ray, const SceneHit& hit);

ShadingPoint shading_point(const RenderPlan& plan, const TraceRay& ray, const SceneHit& hit);

/// A ray from a shading point, which knows what it leaves and to which side.
TraceRay leave(const ShadingPoint& from, const Vec3& direction);

}  // namespace rt
