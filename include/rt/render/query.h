#pragma once
/// The two questions asked of a scene.
#include <optional>
#include <span>

#include "rt/math/rounding.h"
#include "rt/render/plan.h"
#include "rt/render/trace.h"

namespace rt {

/// Two crossings of one ray closer than this, relative to the coordinates that go into t, are one:
/// t carries the rounding of some 16 operations, amplified by 1 / |cos| of the angle of incidence,
/// up to 64.
inline constexpr double tie = gamma(16 * 64);

/// The ray in an instance's model space, with the same parameter t.
Ray model_ray(const RenderPlan& plan, const PlannedInstance& instance, const TraceRay& ray);

/// The nearest crossing with 0 < t. Crossings that coincide within rounding error count as one, and
/// belong to the opaque one among them, else to the first in the plan: surfaces that coincide do
/// not speckle.
std::optional<SceneHit> closest_hit(const RenderPlan& plan, const TraceRay& ray);

/// The same, when only these instances can be crossed.
std::optional<SceneHit> closest_hit_among(const RenderPlan& plan,
                                          std::span<const std::uint32_t> instances,
                                          const TraceRay& ray);

/// The nearest crossing of that one instance with 0 < t <= t_max.
std::optional<SceneHit> instance_hit(const RenderPlan& plan, std::uint32_t instance,
                                     const TraceRay& ray,
                                     double t_max = std::numeric_limits<double>::infinity());

/// The nearest crossing with 0 < t <= t_max of an instance that dims shadow rays.
std::optional<SceneHit> closest_dimming_hit(const RenderPlan& plan, const TraceRay& ray,
                                            double t_max);

/// Whether anything that blocks shadow rays is crossed with 0 < t <= t_max.
bool occluded(const RenderPlan& plan, const TraceRay& ray, double t_max);
/// The same, when only these instances can be.
bool occluded_by(const RenderPlan& plan, std::span<const std::uint32_t> instances,
                 const TraceRay& ray, double t_max);

}  // namespace rt
