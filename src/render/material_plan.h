#pragma once
/// Materials, and the textures that drive them, compiled for a plan.
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "rt/render/plan.h"

namespace rt {

class MaterialPlanner {
 public:
  /// Both must outlive it; the plan's options have to be set before the first index is asked for.
  MaterialPlanner(const RenderJob& job, RenderPlan& plan);

  /// Of what an instance is made of, among the plan's materials: put there when it is met first.
  /// The plan is told what that needs.
  std::uint32_t index_of(const Instance& from);

 private:
  /// What a planned material is made from, by address.
  struct Use {
    const Material* material;
    const TextureSet* textures;
    auto operator<=>(const Use&) const = default;
  };

  std::shared_ptr<const TextureSet> textures(const std::shared_ptr<const TextureSet>& from);
  PlannedMaterial planned(const Material& from, std::shared_ptr<const TextureSet> textures);

  const RenderJob& job_;
  RenderPlan& plan_;
  double brightest_light_ = 0.0;
  std::map<Use, std::uint32_t> known_;
  Use last_use_{};
  std::uint32_t last_index_ = 0;
  std::unordered_map<const TextureSet*, std::shared_ptr<const TextureSet>> textures_;
  /// So that addresses stay their own.
  std::vector<std::pair<std::shared_ptr<const Material>, std::shared_ptr<const TextureSet>>> kept_;
};

/// What instances of that material do to shadow rays, where nothing absorbs.
Shadow shadow_of(const PlannedMaterial& material);

}  // namespace rt
