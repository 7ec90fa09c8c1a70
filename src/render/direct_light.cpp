#include "rt/render/direct_light.h"

#include <cmath>
#include <optional>

#include "local_light.h"
#include "rt/math/rounding.h"
#include "rt/math/spherical_rectangle.h"
#include "rt/math/warp.h"
#include "rt/render/medium.h"
#include "rt/render/query.h"
#include "rt/render/surface_texture.h"

namespace rt {
namespace {

bool is_black(const Rgb& c) { return c.r == 0.0 && c.g == 0.0 && c.b == 0.0; }

/// From inside a sphere its surface fills all directions, and nothing inside shadows it.
LightSample sample_around(const Vec3& from_centre, double radius, const Vec2& u) {
  const Vec3 w = to_cone(u, {2.0});
  const double b = glm::dot(w, from_centre);
  const double c = (radius - glm::length(from_centre)) * (radius + glm::length(from_centre));
  return {w, std::sqrt(std::max(0.0, b * b + c)) - b, 1.0, false};
}

}  // namespace

Vec3 relative_to(const Light& light, const ShadingPoint& point) {
  return point.position - point.time * light.travel;
}

LightSample sample_light(const PlannedLight& light, const ShadingPoint& point,
                         const Sampler& sampler, const Vertex& vertex) {
  const Vec3 p = relative_to(light, point);
  if (light.radius > 0.0) {
    const Vec2 u = sampler.light(vertex);
    const auto s = sample_sphere(u, p, light.position, light.radius);
    return s ? LightSample{s->direction, s->distance}
             : sample_around(p - light.position, light.radius, u);
  }
  if (light.edges) {
    const SphericalRectangle seen(*light.edges, light.first_corner() - p);
    if (!(seen.solid_angle() > 0.0)) {
      return {Vec3(0.0), 1.0, 0.0};
    }
    const auto s = seen.sample(sampler.light(vertex));
    const double distance = glm::length(s.to_point);
    return {s.to_point / distance, distance, 1.0 / (s.pdf * seen.solid_angle())};
  }
  const Vec3 to_light = light.position - p;
  const double distance = glm::length(to_light);
  return {to_light * (1.0 / distance), distance};
}

Rgb dimmed(const RenderPlan& plan, const ShadingPoint& from, const Vec3& way, double reach,
           RayCounts& counts) {
  Rgb share(1.0);
  ShadingPoint at = from;
  for (double rest = reach; !is_black(share);) {
    const TraceRay ray = leave(at, way);
    const auto hit = closest_dimming_hit(plan, ray, rest);
    if (plan.absorbs) {
      share *= transmittance(plan, medium_ahead(plan, at, way), hit ? hit->t : rest);
    }
    if (!hit) {
      break;
    }
    ++counts.shadow;
    at = shading_point(plan, ray, *hit);
    if (!hides(plan, media_about(plan, at, way), hit->instance)) {
      // Towards a point of light the footprint narrows evenly.
      const double width = from.footprint * std::max(0.0, rest - hit->t) / reach;
      const PlannedMaterial& material = plan.material_of(plan.instances[hit->instance]);
      share *= 1.0 - opacity_at(plan, ray, *hit, material, width);
    }
    rest -= hit->t;
  }
  return share;
}

double falloff(const Light& light, double distance) {
  const auto& f = light.falloff;
  return 1.0 / (f.c0 + distance * (f.c1 + distance * f.c2));
}

Rgb reflected(const Phong& phong, const ShadingPoint& point, const Vec3& view, const Vec3& l) {
  const double n_dot_l = glm::dot(point.shading_normal, l);
  // Written so that a light at the very point, l = NaN, gives nothing.
  if (!(n_dot_l > 0.0 && glm::dot(point.normal, l) > 0.0)) {
    return Rgb(0.0);
  }
  Rgb sum = phong.kd * n_dot_l;
  if (!is_black(phong.ks)) {
    const double r_dot_v = 2.0 * n_dot_l * glm::dot(point.shading_normal, view) - glm::dot(l, view);
    if (r_dot_v > phong.least_r_dot_v) {
      sum += phong.ks * std::pow(r_dot_v, phong.shininess);
    }
  }
  return sum;
}

std::optional<Rgb> visibility(const RenderPlan& plan, const Candidates& blockers,
                              const ShadingPoint& from, const Vec3& way, double reach,
                              RayCounts& counts) {
  const bool occluded_here =
      blockers.known ? !blockers.instances.empty() &&
                           occluded_by(plan, blockers.instances, leave(from, way), reach)
                     : occluded(plan, leave(from, way), reach);
  if (occluded_here) {
    return std::nullopt;
  }
  const bool may_dim = plan.dims && (plan.absorbs || !blockers.known || blockers.dims);
  return may_dim ? dimmed(plan, from, way, reach, counts) : Rgb(1.0);
}

double free_distance(const ShadingPoint& from, const Light& light, double distance) {
  return distance - (from.position_error + gamma(4) * max_abs(light.position));
}

Rgb direct_light(const RenderPlan& plan, std::size_t index, const Phong& phong,
                 const ShadingPoint& point, const Vec3& view, const Sampler& sampler,
                 const Vertex& vertex, double negligible, ShadowCache& cache, RayCounts& counts) {
  const PlannedLight& light = plan.lights[index];
  std::optional<SeenLight> seen;
  if (light.extended() && !(is_black(phong.kd) && is_black(phong.ks))) {
    seen = SeenLight::from(relative_to(light, point), light);
  }
  return direct_light(plan, index, seen, phong, point, view, sampler, vertex, negligible, cache,
                      counts);
}

Rgb direct_light(const RenderPlan& plan, std::size_t index, const std::optional<SeenLight>& seen,
                 const Phong& phong, const ShadingPoint& point, const Vec3& view,
                 const Sampler& sampler, const Vertex& vertex, double negligible,
                 ShadowCache& cache, RayCounts& counts) {
  const PlannedLight& light = plan.lights[index];
  if (is_black(phong.kd) && is_black(phong.ks)) {
    return Rgb(0.0);
  }
  if (seen) {
    if (const auto sum = area_light(plan, index, *seen, phong, point, view, sampler, vertex,
                                    negligible, cache, counts)) {
      return *sum;
    }
  }
  const LightSample s = sample_light(light, point, sampler, vertex);
  const Rgb value = reflected(phong, point, view, s.direction) * light.colour *
                    (s.weight * falloff(light, s.distance));
  if (!(max_abs(value) > negligible)) {
    return Rgb(0.0);
  }
  if (!s.shadowed) {
    return value;
  }
  ++counts.shadow;
  const double reach = free_distance(point, light, s.distance);
  const auto share =
      visibility(plan, cache.towards(index, cache.cell_of(point.position)), point, s.direction,
                 reach, counts);
  return share ? value * *share : Rgb(0.0);
}

}  // namespace rt
