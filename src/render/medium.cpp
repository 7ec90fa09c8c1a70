#include "rt/render/medium.h"

#include <cmath>

#include "rt/render/query.h"

namespace rt {
namespace {

/// Whether the space just ahead lies inside the instance: the ray's next crossing leads out.
bool inside(const RenderPlan& plan, std::uint32_t id, const TraceRay& ray) {
  const auto hit = instance_hit(plan, id, ray);
  return hit && shading_point(plan, ray, *hit).side == Leaving::inward;
}

}  // namespace

std::uint32_t medium_ahead(const RenderPlan& plan, const ShadingPoint& point,
                           const Vec3& direction) {
  const TraceRay ray = leave(point, direction);
  for (const std::uint32_t id : plan.media_about(point.instance)) {  // smallest first
    if (inside(plan, id, ray)) {
      return id;
    }
  }
  return no_instance;
}

Media media_about(const RenderPlan& plan, const ShadingPoint& point, const Vec3& direction) {
  const std::span<const std::uint32_t> candidates = plan.media_about(point.instance);
  if (candidates.size() == 1 && candidates[0] == point.instance) {
    // The usual case: nothing transmissive is near but the solid itself.
    return point.side == Leaving::outward ? Media{no_instance, point.instance}
                                          : Media{point.instance, no_instance};
  }
  return {medium_ahead(plan, point, -direction), medium_ahead(plan, point, direction)};
}

double index_of(const RenderPlan& plan, std::uint32_t medium) {
  return medium == no_instance ? 1.0 : plan.materials[plan.instances[medium].material].ior;
}

Rgb transmittance(const RenderPlan& plan, std::uint32_t medium, double distance) {
  if (medium == no_instance) {
    return Rgb(1.0);
  }
  const Rgb& absorption = plan.materials[plan.instances[medium].material].absorption;
  return glm::exp(-absorption * distance);
}

}  // namespace rt
