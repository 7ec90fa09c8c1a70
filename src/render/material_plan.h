#pragma once
/// Materials, and the textures that drive them, compiled for a plan.
#include <unordered_map>
#include <utility>
#include <vector>

#include "rt/render/plan.h"

namespace rt {

class MaterialPlanner {
 public:
  /// Both must outlive it; the plan's options have to be set before the first index is asked for.
  MaterialPlanner(const RenderJob& job, RenderPlan& plan);

  /// The index of what an instance is made of among the plan's coats: put there when it is met
  /// first, equal ones mostly once. The plan is told what that needs.
  std::uint32_t coat_of(const Instance& from);

 private:
  /// A coat, and what it was made from; holding that, so that its address stays its own.
  struct Known {
    std::shared_ptr<const Material> material;
    std::shared_ptr<const TextureSet> textures;
    std::uint32_t coat = 0;
  };

  std::shared_ptr<const TextureSet> textures(const std::shared_ptr<const TextureSet>& from);
  PlannedMaterial planned(const Material& from, std::shared_ptr<const TextureSet> textures);
  std::uint32_t index_of(PlannedMaterial material);

  const RenderJob& job_;
  RenderPlan& plan_;
  double brightest_light_ = 0.0;
  std::vector<Known> known_;              ///< met last, by address
  std::vector<std::uint32_t> materials_;  ///< indices of those met last, by content
  std::unordered_map<const TextureSet*, std::shared_ptr<const TextureSet>> textures_;
};

/// What instances of that material do to shadow rays, where nothing absorbs.
Shadow shadow_of(const PlannedMaterial& material);

}  // namespace rt
