#pragma once
/// The recursive shader: the radiance that arrives along a camera ray.
#include <optional>
#include <vector>

#include "rt/math/sampler.h"
#include "rt/render/accel/shadow_cache.h"
#include "rt/render/footprint.h"
#include "rt/render/surface_texture.h"

namespace rt {

/// The weight below which a branch does not matter, from max_error.
double negligible_branch(const RenderOptions& options);

// A choice between two branches by chance, of probabilities p and 1-p and total weight w, adds
// w sqrt(p (1-p)) to the standard deviation of a sample. Up to this much is accepted: pixels that
// take random decisions average many samples. It needs w >= 2 x this to divide a path, so at most
// 1 / (2 x this) = 10 of the paths alive at one depth, whose weights sum to at most 1, divide
// there. Paths that do not divide die by roulette below `negligible`, so at most 1 / negligible of
// them are alive at one depth.
inline constexpr double accepted_deviation = 0.05;

/// Follows paths through a plan. One a thread; it keeps its memory from sample to sample.
///
/// At glass a path divides. Both branches are followed as long as leaving the choice to chance
/// would add noticeably to the error; after that one is taken, in proportion to their weights,
/// which is unbiased. Where nothing else is random (RenderPlan::random) nothing is left to chance:
/// a branch that can carry no more than `negligible_branch()` of full brightness is not followed.
/// Weights of the branches alive at one depth sum to at most 1, so either rule bounds their number,
/// and the cost is linear in the depth (derivation above).
class Tracer {
 public:
  explicit Tracer(const RenderPlan& plan);

  const RenderPlan& plan() const { return plan_; }

  /// `y` in [0,1], from the picture's top, places a background gradient. `sight`: what the camera
  /// ray can meet. Counts the rays it takes.
  Rgb radiance(const TraceRay& camera_ray, double y, const Sampler& sampler, RayCounts& counts,
               const Candidates& sight = {});

 private:
  struct Path {
    TraceRay ray;
    Rgb throughput;
    Vertex vertex;
    int depth;
  };
  struct Scatter;

  void follow(Path& path);
  Rgb surface(const Scatter& at);
  void scatter(const Scatter& at);
  void divide(const Scatter& at, double reflected, double transmitted);
  void reflect(const Scatter& at, const Rgb& throughput);
  void transmit(const Scatter& at, const Rgb& throughput);
  void add(const Scatter& at, const Vec3& direction, const Rgb& throughput, bool drawn);

  const RenderPlan& plan_;
  double negligible_;
  ShadowCache shadow_cache_;
  std::vector<Path> open_;
  std::optional<FootprintTrail> trail_;  ///< beside open_, where textures want footprints

  // Of the sample being taken.
  Rgb sum_{0.0};
  double y_ = 0.0;
  Candidates sight_;
  const Sampler* sampler_ = nullptr;
  RayCounts* counts_ = nullptr;
};

}  // namespace rt
