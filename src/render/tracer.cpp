#include "rt/render/tracer.h"

#include <algorithm>
#include <cmath>

#include "rt/math/fresnel.h"
#include "rt/render/direct_light.h"
#include "rt/render/medium.h"
#include "rt/render/query.h"

namespace rt {
namespace {

// Branches that are left out, each carrying at most max_error over this many of full brightness,
// must stay well below max_error together. Measured on scenes of glass and mirrors: no pixel is off
// by more than half of max_error (bench/NOTES.md).
constexpr double negligible_branches = 8.0;

double largest(const Rgb& c) { return std::max({c.r, c.g, c.b}); }

/// The mirror direction about the shading normal; about the geometric one where the former would
/// point into the surface.
Vec3 mirrored(const ShadingPoint& point, const Vec3& direction) {
  const Vec3 r = rt::reflect(direction, point.shading_normal);
  return glm::dot(r, point.normal) > 0.0 ? r : rt::reflect(direction, point.normal);
}

}  // namespace

/// A point where a path goes on, and how.
struct Tracer::Scatter {
  const Path& path;
  const ShadingPoint& point;
  const PlannedMaterial& material;
  const Vec3& direction;
  const Reflectances& surface;
  Media media;                ///< of glass
  double n1 = 1.0, n2 = 1.0;  ///< indices of the media before and behind the surface
  bool divided = false;       ///< both branches are followed
  bool chosen = false;        ///< one of them was chosen by chance
};

double negligible_branch(const RenderOptions& options) {
  return options.max_error / negligible_branches;
}

Tracer::Tracer(const RenderPlan& plan)
    : plan_(plan), negligible_(negligible_branch(plan.options)), shadow_cache_(plan) {
  if (plan.footprints) {
    trail_.emplace(plan);
  }
}

Rgb Tracer::radiance(const TraceRay& camera_ray, double y, const Sampler& sampler,
                     RayCounts& counts, const Candidates& sight) {
  sum_ = Rgb(0.0);
  y_ = y;
  sight_ = sight;
  sampler_ = &sampler;
  counts_ = &counts;
  ++counts.camera;
  // From here on all directions have unit length.
  if (trail_) {
    trail_->begin(camera_ray);
  }
  open_.push_back({camera_ray, Rgb(1.0), {}, 0});
  open_.back().ray.direction *= 1.0 / glm::length(camera_ray.direction);
  while (!open_.empty()) {
    Path path = open_.back();
    open_.pop_back();
    follow(path);
  }
  return sum_;
}

void Tracer::follow(Path& path) {
  const auto hit = path.depth == 0 && sight_.known
                       ? closest_hit_among(plan_, sight_.instances, path.ray)
                       : closest_hit(plan_, path.ray);
  if (!hit) {
    const Background& b = plan_.options.background;
    if (plan_.absorbs) {
      path.throughput *= transmittance_beyond(plan_, path.ray);
    }
    sum_ += path.throughput * glm::mix(b.top, b.bottom, y_);
    return;
  }
  ShadingPoint point = shading_point(plan_, path.ray, *hit);
  const PlannedMaterial& material = plan_.material_of(plan_.instances[hit->instance]);
  const Vec3& direction = path.ray.direction;
  if (trail_) {
    trail_->arrive(open_.size(), path.ray, hit->t, point);
  }
  std::optional<Reflectances> look;
  if (material.textures) {
    look = textured(plan_, path.ray, *hit, material, trail_ ? &trail_->here() : nullptr, point);
  }
  Media media{no_instance, no_instance};
  if (material.transmissive) {
    media = media_about(plan_, point, direction);
  } else if (plan_.absorbs) {
    media.before = medium_ahead(plan_, point, -direction);
  }
  if (plan_.absorbs) {
    path.throughput *= transmittance(plan_, media.before, hit->t);
  }
  const bool deepest = path.depth >= plan_.options.max_depth;
  const Scatter at{path, point, material, direction, look ? *look : plan_.plain(plan_.instances[hit->instance]), media};
  if (material.transmissive && hides(plan_, media, hit->instance)) {
    if (!deepest) {
      add(at, direction, path.throughput, false);
    }
    return;
  }
  sum_ += path.throughput * surface(at);
  if (!deepest) {
    scatter(at);
  }
}

Rgb Tracer::surface(const Scatter& at) {
  const Phong phong{at.surface.kd * at.surface.opacity, at.surface.ks, at.material.shininess,
                    at.material.least_r_dot_v};
  const double negligible =
      negligible_light(plan_.options, plan_.lights.size()) / largest(at.path.throughput);
  Rgb sum = at.material.emission + phong.kd * plan_.ambient;
  const auto lights = static_cast<std::uint32_t>(plan_.lights.size());
  for (std::uint32_t i = 0; i < lights; ++i) {
    const Vertex vertex{at.path.vertex.order, at.path.vertex.copy * lights + i};
    sum += direct_light(plan_, i, phong, at.point, -at.direction, *sampler_, vertex, negligible,
                        shadow_cache_, *counts_);
  }
  return sum;
}

void Tracer::scatter(const Scatter& at) {
  if (!at.material.transmissive) {
    if (plan_.options.reflection) {
      reflect(at, at.path.throughput * at.material.reflectivity);
    }
    return;
  }
  Scatter glass = at;
  glass.n1 = index_of(plan_, at.media.before);
  glass.n2 = index_of(plan_, at.media.behind);
  const double cos_i = std::min(1.0, std::abs(glm::dot(at.direction, at.point.shading_normal)));
  const double f = fresnel(cos_i, glass.n1, glass.n2);
  divide(glass, plan_.options.reflection ? f : 0.0, (1.0 - at.surface.opacity) * (1.0 - f));
}

void Tracer::divide(const Scatter& at, double reflected, double transmitted) {
  const Rgb& throughput = at.path.throughput;
  const double total = reflected + transmitted;
  const double p = total > 0.0 ? reflected / total : 0.0;
  const double deviation = largest(throughput) * total * std::sqrt(p * (1.0 - p));
  if (!plan_.random || deviation > accepted_deviation || p == 0.0 || p == 1.0) {
    Scatter both = at;
    both.divided = reflected > 0.0 && transmitted > 0.0;
    transmit(both, throughput * transmitted);
    reflect(both, throughput * reflected);
  } else {
    Scatter one = at;
    one.chosen = true;
    if (sampler_->lobe_choice(at.path.vertex) < p) {
      reflect(one, throughput * total);
    } else {
      transmit(one, throughput * total);
    }
  }
}

void Tracer::reflect(const Scatter& at, const Rgb& throughput) {
  if (!(largest(throughput) > 0.0)) {
    return;
  }
  const Vec3 mirror = mirrored(at.point, at.direction);
  if (!at.material.lobe) {
    add(at, mirror, throughput, false);
    return;
  }
  const auto s = at.material.lobe->sample(sampler_->lobe(at.path.vertex), mirror, at.point.normal);
  add(at, s.direction, throughput * s.weight, true);
}

void Tracer::transmit(const Scatter& at, const Rgb& throughput) {
  if (!(largest(throughput) > 0.0)) {
    return;
  }
  const auto through = refract(at.direction, at.point.shading_normal, at.n1, at.n2);
  if (!through) {
    return;
  }
  // On meshes a shading normal may send the ray back out; then the geometric one decides.
  const Vec3 ahead =
      glm::dot(*through, at.point.normal) < 0.0
          ? *through
          : refract(at.direction, at.point.normal, at.n1, at.n2).value_or(at.direction);
  if (!at.material.lobe) {
    add(at, ahead, throughput, false);
    return;
  }
  const auto s = at.material.lobe->sample(sampler_->lobe(at.path.vertex), ahead, -at.point.normal);
  add(at, s.direction, throughput * s.weight, true);
}

void Tracer::add(const Scatter& at, const Vec3& direction, const Rgb& throughput, bool drawn) {
  Path next{leave(at.point, direction), throughput, at.path.vertex, at.path.depth + 1};
  const bool outward = glm::dot(direction, at.point.normal) > 0.0;
  if (at.divided) {
    // Branches are told apart as the nodes of a binary tree; they wrap harmlessly far down.
    next.vertex.copy = 2 * next.vertex.copy + (outward ? 2 : 1);
  }
  if (drawn || at.chosen) {
    ++next.vertex.order;
  }
  const double weight = largest(throughput);
  if (weight < negligible_) {
    if (!plan_.random) {
      return;
    }
    // Roulette: the survivors carry the weight of the others. Its draw is multiplied with those
    // before and after it, so it has an order of its own.
    if (sampler_->lobe_choice(next.vertex) * negligible_ >= weight) {
      return;
    }
    ++next.vertex.order;
    next.throughput *= negligible_ / weight;
  }
  if (trail_) {
    trail_->branch(at.point, at.direction, direction, at.n1 / at.n2,
                   drawn ? &*at.material.lobe : nullptr);
  }
  ++(outward ? counts_->reflection : counts_->refraction);
  open_.push_back(next);
}

}  // namespace rt
