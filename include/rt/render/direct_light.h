#pragma once
#include "rt/math/sampler.h"
#include "rt/render/accel/shadow_cache.h"
#include "rt/render/seen_light.h"
#include "rt/render/shading.h"

namespace rt {

/// The reflectances in force at a point: textures resolved.
struct Phong {
  Rgb kd;
  Rgb ks;
  double shininess;
  double least_r_dot_v;  ///< below it the highlight is negligible
};

/// A point of a light, seen from a shading point.
struct LightSample {
  Vec3 direction;  ///< unit
  double distance;
  double weight = 1.0;   ///< density uniform in solid angle over the density drawn from
  bool shadowed = true;  ///< false: nothing can stand between
};

LightSample sample_light(const PlannedLight& light, const ShadingPoint& point,
                         const Sampler& sampler, const Vertex& vertex);

/// What share of light gets from a point over a distance `reach` in direction `way` (unit), past
/// what dims; nothing blocks it.
Rgb dimmed(const RenderPlan& plan, const ShadingPoint& from, const Vec3& way, double reach,
           RayCounts& counts);

/// Light `index`, reflected towards `view` (unit): sum over the light's directions, visibility
/// included. An extended light is the mean of point lights over the directions that it subtends,
/// uniform in solid angle; one sample of that mean is taken, drawn at `vertex`. Contributions that
/// are below `negligible` in every channel are left out, and cost no shadow ray.
Rgb direct_light(const RenderPlan& plan, std::size_t index, const Phong& phong,
                 const ShadingPoint& point, const Vec3& view, const Sampler& sampler,
                 const Vertex& vertex, double negligible, ShadowCache& cache, RayCounts& counts);

/// The same for an extended light whose sight from the point (where the light then stands) is
/// known: SeenLight::from.
Rgb direct_light(const RenderPlan& plan, std::size_t index, const std::optional<SeenLight>& seen,
                 const Phong& phong, const ShadingPoint& point, const Vec3& view,
                 const Sampler& sampler, const Vertex& vertex, double negligible,
                 ShadowCache& cache, RayCounts& counts);

}  // namespace rt
