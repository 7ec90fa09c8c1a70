#include "rt/render/medium.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ranges>
#include <variant>

#include "rt/render/query.h"

namespace rt {
namespace {

/// Whether the instance's next crossing leads out of it; empty when there is none.
std::optional<bool> leads_out(const RenderPlan& plan, std::uint32_t id, const TraceRay& ray) {
  const auto hit = instance_hit(plan, id, ray);
  return hit ? std::optional(shading_point(plan, ray, *hit).side == Leaving::inward) : std::nullopt;
}

/// Whether the space just ahead lies inside the instance.
bool inside(const RenderPlan& plan, std::uint32_t id, const TraceRay& ray) {
  if (ray.instance == id) {
    return ray.leaving == Leaving::inward;
  }
  if (const auto out = leads_out(plan, id, ray)) {
    return *out;
  }
  if (!plan.instances[id].is<Plane>()) {
    return false;
  }
  // A plane bounds the half-space below it, which has no end ahead of a ray that goes down. Then
  // the plane lies behind, unless the ray starts on it or runs along it.
  TraceRay back = ray;
  back.direction = -ray.direction;
  if (const auto out = leads_out(plan, id, back)) {
    return *out;
  }
  const Ray in_model = model_ray(plan, plan.instances[id], ray);
  return in_model.direction.y < 0.0 || (in_model.direction.y == 0.0 && in_model.origin.y < 0.0);
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

bool hides(const RenderPlan& plan, const Media& media, std::uint32_t instance) {
  if (media.before != media.behind || media.before == no_instance) {
    return false;
  }
  const auto candidates = plan.media_about(instance);  // smallest first
  return std::ranges::find(candidates, media.before) < std::ranges::find(candidates, instance);
}

double index_of(const RenderPlan& plan, std::uint32_t medium) {
  return medium == no_instance ? 1.0 : plan.material_of(plan.instances[medium]).ior;
}

Rgb transmittance(const RenderPlan& plan, std::uint32_t medium, double distance) {
  if (medium == no_instance) {
    return Rgb(1.0);
  }
  const Rgb& absorption = plan.material_of(plan.instances[medium]).absorption;
  return glm::exp(-absorption * distance);
}

Rgb transmittance_beyond(const RenderPlan& plan, const TraceRay& ray) {
  for (const std::uint32_t id : std::views::reverse(plan.unbounded())) {  // as media_about() orders
    const PlannedMaterial& material = plan.material_of(plan.instances[id]);
    if (material.transmissive && inside(plan, id, ray)) {
      return 1.0 - glm::step(std::numeric_limits<double>::min(), material.absorption);
    }
  }
  return Rgb(1.0);
}

}  // namespace rt
