#pragma once
/// Which medium a ray travels in. Nothing is carried along: at every hit the media before and
/// behind the surface follow from the geometry alone, so that nested, overlapping and touching
/// solids, and a camera inside one, need no rule of their own.
#include "rt/render/shading.h"

namespace rt {

/// The transmissive instance whose medium fills the space just ahead of `point` in `direction`, or
/// no_instance for the open air. Of several solids that overlap there the smallest (by the volume
/// of its box) counts: a bubble in glass is air, a ball in water is glass. A plane is the surface
/// of the half-space below it, the largest solid of all.
std::uint32_t medium_ahead(const RenderPlan& plan, const ShadingPoint& point,
                           const Vec3& direction);

/// The media on the two sides of a surface, for a ray that arrives in `direction`.
struct Media {
  std::uint32_t before;
  std::uint32_t behind;
};
Media media_about(const RenderPlan& plan, const ShadingPoint& point, const Vec3& direction);

/// Whether a transmissive instance's surface between these media lies inside a smaller solid, whose
/// medium displaces the instance's own: then there is no surface.
bool hides(const RenderPlan& plan, const Media& media, std::uint32_t instance);

/// Index of refraction of a medium; 1 for the open air.
double index_of(const RenderPlan& plan, std::uint32_t medium);

/// Beer-Lambert transmittance over a distance in a medium.
Rgb transmittance(const RenderPlan& plan, std::uint32_t medium, double distance);

/// What arrives through the medium ahead of a ray that meets nothing: only half-spaces have no end.
Rgb transmittance_beyond(const RenderPlan& plan, const TraceRay& ray);

}  // namespace rt
