#include "nesting/tracer.h"

#include <cmath>
#include <stdexcept>

#include "rt/math/fresnel.h"
#include "rt/render/query.h"

namespace rt::bench {
namespace {

bool done_here(const RenderJob& job) {
  bool simple = !job.camera.to && job.camera.aperture == 0.0;
  for (const Instance& instance : job.instances) {
    simple = simple && !instance.textures && instance.material->opacity == 1.0;
  }
  return simple;
}

}  // namespace

NestedTracer::NestedTracer(const RenderJob& job, const RenderPlan& plan, const Nesting& nesting)
    : plan_(plan),
      nesting_(nesting),
      side_(static_cast<int>(std::lround(std::sqrt(nesting.camera)))),
      cache_(plan) {
  if (!done_here(job)) {
    throw std::invalid_argument("no textures, glass, lenses or moving cameras");
  }
  if (side_ * side_ != nesting.camera) {
    throw std::invalid_argument("the number of camera samples must be a square");
  }
  if (nesting.spread == Spread::stratified) {
    if (nesting.nest != 1 || plan.lights.size() != 1 || plan.options.max_depth > 0) {
      throw std::invalid_argument("stratified: one light, no reflections, no nesting");
    }
    strata_.emplace(side_);
  }
}

/// Where in a pixel the camera sample of a cell falls.
Vec2 NestedTracer::place(int cell) {
  const Vec2 at = Sampler(++sets_, 0, 0, 0).pixel();
  if (nesting_.spread == Spread::random) {
    return at;
  }
  return Vec2(cell % side_ + at.x, cell / side_ + at.y) / static_cast<double>(side_);  // NOLINT
}

Rgb NestedTracer::pixel(int x, int y) {
  const int times = plan_.moves ? nesting_.nest : 1;
  const std::uint64_t set = mix64(++sets_);
  Rgb sum(0.0);
  for (int cell = 0; cell < nesting_.camera; ++cell) {
    const Vec2 p = (Vec2(x, y) + place(cell)) / Vec2(plan_.options.width, plan_.options.height);
    stratum_ = strata_ ? &strata_->at(set, cell) : nullptr;
    const Draws draws = decide();
    for (int i = 0; i < times; ++i) {
      TraceRay ray{Vec3(0.0), glm::normalize(plan_.camera.direction(p.x, p.y))};
      ray.time = plan_.moves ? draws(i).time() : 0.0;
      ++counts_.camera;
      sum += radiance(ray, p.y, 0);
    }
  }
  return sum / static_cast<double>(nesting_.camera * times);
}

Rgb NestedTracer::radiance(const TraceRay& ray, double y, int depth) {
  const auto hit = closest_hit(plan_, ray);
  if (!hit) {
    return glm::mix(plan_.options.background.top, plan_.options.background.bottom, y);
  }
  const ShadingPoint point = shading_point(plan_, ray, *hit);
  const PlannedInstance& instance = plan_.instances[hit->instance];
  const PlannedMaterial& material = plan_.material_of(instance);
  const Reflectances plain = plan_.plain(instance);
  Rgb sum = material.emission + plain.kd * plan_.ambient;
  for (std::size_t i = 0; i < plan_.lights.size(); ++i) {
    sum += lit(i, point, plain, material, ray.direction);
  }
  if (depth < plan_.options.max_depth && max_abs(material.reflectivity) > 0.0) {
    sum += material.reflectivity * reflected(point, material, ray.direction, y, depth);
  }
  return sum;
}

Rgb NestedTracer::lit(std::size_t light, const ShadingPoint& point, const Reflectances& plain,
                      const PlannedMaterial& material, const Vec3& direction) {
  const Phong phong{plain.kd, plain.ks, material.shininess, material.least_r_dot_v};
  const bool extended = plan_.lights[light].rectangle || plan_.lights[light].radius > 0.0;
  const int count = extended ? nesting_.nest : 1;
  const Draws draws = stratum_ != nullptr ? Draws(*stratum_) : decide();
  Rgb sum(0.0);
  for (int i = 0; i < count; ++i) {
    sum += direct_light(plan_, light, phong, point, -direction, draws(i), {},
                        negligible_light(plan_.options, plan_.lights.size()), cache_, counts_);
  }
  return sum / static_cast<double>(count);
}

Rgb NestedTracer::reflected(const ShadingPoint& point, const PlannedMaterial& material,
                            const Vec3& direction, double y, int depth) {
  const Vec3 mirror = reflect(direction, point.normal);
  const int count = material.lobe ? nesting_.nest : 1;
  const Draws draws = decide();
  Rgb sum(0.0);
  for (int i = 0; i < count; ++i) {
    PowerCosineLobe::Sample s{mirror, 1.0};
    if (material.lobe) {
      s = material.lobe->sample(draws(i).lobe(), mirror, point.normal);
    }
    ++counts_.reflection;
    sum += s.weight * radiance(leave(point, s.direction), y, depth + 1);
  }
  return sum / static_cast<double>(count);
}

}  // namespace rt::bench
