#include "material_plan.h"

#include <bit>
#include <cmath>

#include "rt/math/hash.h"
#include "rt/render/surface_texture.h"

namespace rt {
namespace {

constexpr std::size_t met_last = 1024;
constexpr std::uint32_t none = ~0U;

std::size_t place_of(const void* material, const void* textures) {
  return combine(reinterpret_cast<std::uintptr_t>(material),
                 reinterpret_cast<std::uintptr_t>(textures)) %
         met_last;
}

/// Of what mostly tells materials apart.
std::size_t place_of(const PlannedMaterial& m) {
  const double numbers[] = {m.ks.r,        m.ks.g,         m.ks.b,           m.shininess,
                            m.opacity,     m.ior,          m.reflectivity.r, m.reflectivity.g,
                            m.absorption.r, m.emission.r};
  std::uint64_t hash = reinterpret_cast<std::uintptr_t>(m.textures.get());
  for (const double number : numbers) {
    hash = combine(hash, std::bit_cast<std::uint64_t>(number));
  }
  return hash % met_last;
}

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

std::uint32_t MaterialPlanner::coat_of(const Instance& from) {
  known_.resize(met_last);
  Known& known = known_[place_of(from.material.get(), from.textures.get())];
  if (known.material != from.material || known.textures != from.textures) {
    const std::uint32_t material = index_of(planned(*from.material, textures(from.textures)));
    known = {from.material, from.textures, static_cast<std::uint32_t>(plan_.coats.size())};
    plan_.coats.emplace_back(from.material->kd, material);
  }
  return known.coat;
}

std::uint32_t MaterialPlanner::index_of(PlannedMaterial material) {
  materials_.resize(met_last, none);
  std::uint32_t& last = materials_[place_of(material)];
  if (last == none || plan_.materials[last] != material) {
    last = static_cast<std::uint32_t>(plan_.materials.size());
    plan_.materials.push_back(std::move(material));
  }
  return last;
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
  PlannedMaterial to{from.ks,        from.reflectivity, from.absorption, from.emission,
                     from.shininess, from.ior,          from.opacity,    {}};
  plan_.footprints |= textures && options.texture_filter;
  to.textures = std::move(textures);
  if (!options.refraction) {
    to.opacity = 1.0;
  }
  to.transmissive = to.opacity < 1.0 || driven(to, TextureSlot::opacity);
  const double brightest = max_abs(to.ks) * brightest_light_;
  if (to.shininess > 0.0 && brightest > 0.0 && !driven(to, TextureSlot::ks)) {
    to.least_r_dot_v =
        std::pow(negligible_light(options, job_.lights.size()) / brightest, 1.0 / to.shininess);
  }
  const bool mirrors = to.transmissive || to.reflectivity != Rgb(0.0);
  if (mirrors && options.glossy && from.glossiness > 0.0) {
    to.lobe.emplace(2.0 / (from.glossiness * from.glossiness) - 2.0);
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
