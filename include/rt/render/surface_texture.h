#pragma once
/// Textures applied at a hit.
#include "rt/render/footprint.h"
#include "rt/render/shading.h"

namespace rt {

/// Looks up the textures of the instance that was hit, over the footprint `here` (null: at points,
/// unfiltered), and tilts the point's shading normal by its bump or normal map. The normal stays on
/// the side from which the ray came, both against the surface and against the ray, so that no light
/// leaks through and nothing seen is black for facing away.
Reflectances textured(const RenderPlan& plan, const TraceRay& ray, const SceneHit& hit,
                      const PlannedMaterial& material, const RayDifferential* here,
                      ShadingPoint& point);

/// The opacity where a shadow ray crosses a surface; `width`: of its footprint there.
double opacity_at(const RenderPlan& plan, const TraceRay& ray, const SceneHit& hit,
                  const PlannedMaterial& material, double width);

/// The instance's textures that the options leave in force; null where there are none.
std::shared_ptr<const TextureSet> in_force(const std::shared_ptr<const TextureSet>& textures,
                                           const RenderOptions& options);

}  // namespace rt
