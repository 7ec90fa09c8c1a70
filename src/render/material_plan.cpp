#include "material_plan.h"

#include <cmath>

#include "rt/render/surface_texture.h"

namespace rt {
namespace {

bool driven(const PlannedMaterial& material, TextureSlot slot) {
  return material.textures && (*material.textures)[slot].texture;
}

}  // namespace

MaterialPlanner::MaterialPlanner(const RenderJob& job, RenderPlan& plan) : job_(job), plan_(plan) {
  for (const Light& light : job.lights) {
    // Its colour over the least of the falloff; endless where nothing bounds that.
    brightest_light_ = std::max(brightest_light_, max_abs(light.colour) / light.falloff.c0);
  }
}

std::uint32_t MaterialPlanner::index_of(const Instance& from) {
  const Use use{from.material.get(), from.textures.get()};
  if (use == last_use_) {
    return last_index_;
  }
  const auto [entry, added] =
      known_.try_emplace(use, static_cast<std::uint32_t>(plan_.materials.size()));
  if (added) {
    plan_.materials.push_back(planned(*from.material, textures(from.textures)));
    kept_.emplace_back(from.material, from.textures);
  }
  last_use_ = use;
  last_index_ = entry->second;
  return last_index_;
}

/// Those in force, found once for each set.
std::shared_ptr<const TextureSet> MaterialPlanner::textures(
    const std::shared_ptr<const TextureSet>& from) {
  if (!from) {
    return nullptr;
  }
  const auto [entry, added] = textures_.try_emplace(from.get());
  if (added) {
    entry->second = in_force(from, plan_.options);
  }
  return entry->second;
}

PlannedMaterial MaterialPlanner::planned(const Material& from,
                                         std::shared_ptr<const TextureSet> textures) {
  const RenderOptions& options = plan_.options;
  PlannedMaterial to{from};
  plan_.footprints |= textures && options.texture_filter;
  to.textures = std::move(textures);
  if (!options.refraction) {
    to.opacity = 1.0;
  }
  if (!options.glossy) {
    to.glossiness = 0.0;
  }
  to.plain = {to.kd, to.ks, to.opacity};
  to.transmissive = to.opacity < 1.0 || driven(to, TextureSlot::opacity);
  const double brightest = max_abs(to.ks) * brightest_light_;
  if (to.shininess > 0.0 && brightest > 0.0 && !driven(to, TextureSlot::ks)) {
    to.least_r_dot_v =
        std::pow(negligible_light(options, job_.lights.size()) / brightest, 1.0 / to.shininess);
  }
  const bool mirrors = to.transmissive || to.reflectivity != Rgb(0.0);
  if (mirrors && to.glossiness > 0.0) {
    to.lobe.emplace(2.0 / (to.glossiness * to.glossiness) - 2.0);
    plan_.random = true;
  }
  plan_.absorbs |= to.transmissive && to.absorption != Rgb(0.0);
  return to;
}

Shadow shadow_of(const PlannedMaterial& material) {
  if (!material.transmissive) {
    return Shadow::blocks;
  }
  return !driven(material, TextureSlot::opacity) && material.opacity == 0.0 &&
                 material.absorption == Rgb(0.0)
             ? Shadow::none
             : Shadow::dims;
}

}  // namespace rt
