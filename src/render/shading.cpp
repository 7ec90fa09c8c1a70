#include "rt/render/shading.h"

#include <cmath>

#include "rt/math/rounding.h"
#include "rt/render/query.h"

namespace rt {

SurfacePoint model_point(const RenderPlan& plan, const TraceRay& ray, const SceneHit& hit) {
  const PlannedInstance& instance = plan.instances[hit.instance];
  const Ray in_model = model_ray(plan, instance, ray);
  const ShapeHit model_hit{hit.t, hit.feature};
  return plan.visit(instance,
                    [&](const auto& shape) { return surface_point(shape, in_model, model_hit); });
}

RayCounts& RayCounts::operator+=(const RayCounts& other) {
  camera += other.camera;
  shadow += other.shadow;
  reflection += other.reflection;
  refraction += other.refraction;
  return *this;
}

ShadingPoint shading_point(const RenderPlan& plan, const TraceRay& ray, const SceneHit& hit) {
  const PlannedInstance& instance = plan.instances[hit.instance];
  const Ray in_model = model_ray(plan, instance, ray);
  const ShapeHit model_hit{hit.t, hit.feature};
  const SurfacePoint p = plan.visit(
      instance, [&](const auto& shape) { return surface_point(shape, in_model, model_hit); });
  ShadingPoint point;
  plan.map(instance, ray.time, [&](const auto& map) {
    point.position = map.render_point(p.position);
    // The refined point lies on the surface to a few roundings of its own coordinates; the map to
    // render space adds three products and three sums a component.
    point.position_error =
        gamma(16) * (map.render_per_model() * max_abs(p.position) + max_abs(map.offset));
    // Mirroring turns triangles inside out, but not their normals: the outward side stays outward.
    point.normal = map.render_normal(p.normal);
    point.shading_normal =
        p.shading_normal == p.normal ? point.normal : map.render_normal(p.shading_normal);
  });
  const bool from_outside = glm::dot(p.normal, in_model.direction) <= 0.0;
  point.side = from_outside ? Leaving::outward : Leaving::inward;
  if (!from_outside) {
    point.normal = -point.normal;
    point.shading_normal = -point.shading_normal;
  }
  point.instance = hit.instance;
  point.feature = hit.feature;
  point.time = ray.time;
  return point;
}

TraceRay leave(const ShadingPoint& from, const Vec3& direction) {
  const bool to_seen_side = glm::dot(from.normal, direction) >= 0.0;
  const bool outward = to_seen_side == (from.side == Leaving::outward);
  return {from.position,
          direction,
          from.instance,
          from.feature,
          outward ? Leaving::outward : Leaving::inward,
          from.position_error,
          from.time};
}

}  // namespace rt
