#pragma once
#include <optional>

#include "nesting/draws.h"
#include "rt/render/direct_light.h"

namespace rt::bench {

struct Nesting {
  int camera = 1;  ///< samples over a pixel, a square number
  int nest = 1;    ///< samples of each decision
  Spread spread = Spread::random;
};

/// Takes every camera sample at several times, sends several rays to each light from every hit and
/// several into its lobe, and so on down: a tree of rays where the renderer follows one path.
class NestedTracer {
 public:
  /// `plan`: of `job`. Throws std::invalid_argument where the scene has what is not done here:
  /// textures, glass, lenses, moving cameras; or the nesting cannot be had.
  NestedTracer(const RenderJob& job, const RenderPlan& plan, const Nesting& nesting);

  Rgb pixel(int x, int y);
  const RayCounts& counts() const { return counts_; }

 private:
  Draws decide() { return {nesting_.spread, ++sets_}; }
  Vec2 place(int cell);
  Rgb radiance(const TraceRay& ray, double y, int depth);
  Rgb lit(std::size_t light, const ShadingPoint& point, const Reflectances& plain,
          const PlannedMaterial& material, const Vec3& direction);
  Rgb reflected(const ShadingPoint& point, const PlannedMaterial& material, const Vec3& direction,
                double y, int depth);

  const RenderPlan& plan_;
  Nesting nesting_;
  int side_;
  std::optional<Strata> strata_;
  const Sampler* stratum_ = nullptr;  ///< of the camera sample at hand
  ShadowCache cache_;
  RayCounts counts_;
  std::uint64_t sets_ = 0;
};

}  // namespace rt::bench
