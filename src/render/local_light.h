#pragma once
/// What lights give at a point: the parts that direct_light() and area_light() share.
#include <optional>

#include "rt/render/direct_light.h"

namespace rt {

/// A point relative to a light that moves: where it is when the light is taken to stand still.
Vec3 relative_to(const Light& light, const ShadingPoint& point);

/// How a light dims with distance.
double falloff(const Light& light, double distance);

/// kd (n.l) + ks (r.v)^shininess, where the light stands above the surface.
Rgb reflected(const Phong& phong, const ShadingPoint& point, const Vec3& view, const Vec3& l);

/// What share of a light arrives at a point from `reach` away in direction `way` (unit): none
/// behind anything that blocks, so that no light is too bright to be hidden, less than 1 behind
/// what dims. `blockers`: what can block; when they are not known, everything.
std::optional<Rgb> visibility(const RenderPlan& plan, const Candidates& blockers,
                              const ShadingPoint& from, const Vec3& way, double reach,
                              RayCounts& counts);

/// The distance to be free towards a light's point: a surface through the light, as far as rounding
/// can tell, does not shadow it.
double free_distance(const ShadingPoint& from, const Light& light, double distance);

/// direct_light() for an extended light of which few things can hide anything, those known. Empty
/// where it does not apply.
std::optional<Rgb> area_light(const RenderPlan& plan, std::size_t index, const SeenLight& seen,
                              const Phong& phong, const ShadingPoint& point, const Vec3& view,
                              const Sampler& sampler, const Vertex& vertex, double negligible,
                              ShadowCache& cache, RayCounts& counts);

}  // namespace rt
