#include "rt/render/shading.h"

#include <cmath>

#include "rt/math/rounding.h"
#include "rt/render/query.h"

namespace rt {
namespace {

bool is_black(const Rgb& c) { return c.r == 0.0 && c.g == 0.0 && c.b == 0.0; }

Vec3 unit_transposed(const Mat3& m, const Vec3& n) {
  // n * m is transpose(m) n. Scaled by its largest entry first: a world 1e200 times smaller or
  // larger still has unit normals.
  const Vec3 v = n * m;
  return glm::normalize(v / max_abs(v));
}

double falloff(const Light& light, double distance) {
  const auto& f = light.falloff;
  return 1.0 / (f.c0 + distance * (f.c1 + distance * f.c2));
}

/// Direct light from a point light.
Rgb direct(const RenderPlan& plan, const Light& light, const Material& material,
           const ShadingPoint& point, const Vec3& view, RayCounts& counts) {
  const Vec3 to_light = light.position - point.position;
  const double distance = glm::length(to_light);
  const Vec3 l = to_light / distance;
  const double n_dot_l = glm::dot(point.shading_normal, l);
  // Written so that a light at the very point, l = NaN, gives nothing.
  if (!(n_dot_l > 0.0 && glm::dot(point.normal, l) > 0.0)) {
    return Rgb(0.0);
  }
  Rgb reflected = material.kd * n_dot_l;
  if (!is_black(material.ks)) {
    const double r_dot_v = 2.0 * n_dot_l * glm::dot(point.shading_normal, view) - glm::dot(l, view);
    if (r_dot_v > 0.0) {
      reflected += material.ks * std::pow(r_dot_v, material.shininess);
    }
  }
  const Rgb arriving = light.colour * falloff(light, distance);
  if (is_black(reflected) || is_black(arriving)) {
    return Rgb(0.0);
  }
  ++counts.shadow;
  // A surface through the light, as far as rounding can tell, does not shadow it.
  const double t_max = 1.0 - (point.position_error + gamma(4) * max_abs(light.position)) / distance;
  return occluded(plan, leave(point, to_light), t_max) ? Rgb(0.0) : reflected * arriving;
}

/// The mirror direction about the shading normal; about the geometric one where the former would
/// point into the surface.
Vec3 mirrored(const ShadingPoint& point, const Vec3& direction) {
  const Vec3 r = glm::reflect(direction, point.shading_normal);
  return glm::dot(r, point.normal) > 0.0 ? r : glm::reflect(direction, point.normal);
}

Rgb background(const RenderOptions& options, double y) {
  return glm::mix(options.background.top, options.background.bottom, y);
}

}  // namespace

RayCounts& RayCounts::operator+=(const RayCounts& other) {
  camera += other.camera;
  shadow += other.shadow;
  reflection += other.reflection;
  return *this;
}

ShadingPoint shading_point(const RenderPlan& plan, const TraceRay& ray, const SceneHit& hit) {
  const PlannedInstance& instance = plan.instances[hit.instance];
  const Ray in_model = model_ray(instance, ray);
  const ShapeHit model_hit{hit.t, hit.feature};
  const SurfacePoint p =
      std::visit([&](const auto& shape) { return surface_point(shape, in_model, model_hit); },
                 *instance.shape);
  ShadingPoint point;
  point.position = instance.render_from_model.point(p.position);
  // The refined point lies on the surface to a few roundings of its own coordinates; the map to
  // render space adds three products and three sums a component.
  point.position_error = gamma(16) * (instance.render_per_model * max_abs(p.position) +
                                      max_abs(instance.render_from_model.offset));
  // Normals map by the inverse transpose. Mirroring turns triangles inside out, but not their
  // normals: the outward side stays outward.
  point.normal = unit_transposed(instance.model_from_render.linear, p.normal);
  point.shading_normal = p.shading_normal == p.normal
                             ? point.normal
                             : unit_transposed(instance.model_from_render.linear, p.shading_normal);
  const bool from_outside = glm::dot(p.normal, in_model.direction) <= 0.0;
  point.side = from_outside ? Leaving::outward : Leaving::inward;
  if (!from_outside) {
    point.normal = -point.normal;
    point.shading_normal = -point.shading_normal;
  }
  point.instance = hit.instance;
  point.feature = hit.feature;
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
          from.position_error};
}

Rgb radiance(const RenderPlan& plan, const TraceRay& camera_ray, double y, RayCounts& counts) {
  Rgb sum(0.0);
  Rgb throughput(1.0);
  TraceRay ray = camera_ray;
  ++counts.camera;
  for (int depth = 0;; ++depth) {
    const auto hit = closest_hit(plan, ray);
    if (!hit) {
      return sum + throughput * background(plan.options, y);
    }
    const ShadingPoint point = shading_point(plan, ray, *hit);
    const Material& material = plan.materials[plan.instances[hit->instance].material];
    const Vec3 direction = glm::normalize(ray.direction);
    Rgb local = material.emission + material.kd * plan.ambient;
    for (const Light& light : plan.lights) {
      local += direct(plan, light, material, point, -direction, counts);
    }
    sum += throughput * local;
    throughput *= material.reflectivity;
    if (is_black(throughput) || depth >= plan.options.max_depth || !plan.options.reflection) {
      return sum;
    }
    ++counts.reflection;
    ray = leave(point, mirrored(point, direction));
  }
}

}  // namespace rt
