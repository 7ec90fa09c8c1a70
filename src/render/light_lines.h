#pragma once
/// Lines across an extended light, and what of them is seen past a few blockers.
#include <array>

#include "rt/geometry/fan.h"
#include "rt/render/accel/shadow_cache.h"
#include "rt/render/seen_light.h"
#include "rt/render/shading.h"

namespace rt {

/// A few instances.
struct FewInstances {
  std::array<std::uint32_t, ShadowCache::most> ids;
  std::size_t count = 0;

  void add(std::uint32_t id) { ids[count++] = id; }
  std::span<const std::uint32_t> span() const { return {ids.data(), count}; }
};

/// What may hide a light from a point.
struct Blockers {
  struct Convex {
    std::uint32_t id;
    Vec3 origin;     ///< the point in its model space
    double nearest;  ///< Fan::nearest
  };
  const RenderPlan& scene;
  std::array<Convex, ShadowCache::most> convex;  ///< of which lines can tell
  std::size_t convex_count = 0;
  FewInstances others;  ///< of which rays must
  bool dims = false;    ///< something dims

  Blockers(const RenderPlan& plan, const Candidates& candidates, const ShadingPoint& point,
           const SeenLight& seen);
  bool none() const { return convex_count + others.count == 0 && !dims; }
};

/// The parts of a line that convex blockers leave to be seen.
class VisibleParts {
 public:
  /// Those of which the line cannot tell after all are added to `unknown`.
  VisibleParts(const LightLine& line, const Blockers& blockers, FewInstances& unknown);

  /// All together, in the line's units.
  double angle() const { return angle_; }
  /// Nothing is hidden.
  bool all() const { return all_; }
  /// The integral of n.l over their angle.
  double cosine(const Vec3& n) const;
  /// The direction at a share u in (0,1) of the visible angle; there must be some.
  Vec3 direction(double u) const;

 private:
  double angle_of(const Span& part) const {
    return line_.angle_to(part.hi) - line_.angle_to(part.lo);
  }
  void add(double lo, double hi);

  const LightLine& line_;
  std::array<Span, ShadowCache::most + 1> parts_;
  std::size_t count_ = 0;
  double angle_ = 0.0;
  bool all_ = false;
};

/// The mean of n.l over a light of which a point sees what blockers leave, by lines.
class Lines {
 public:
  Lines(const ShadingPoint& point, const SeenLight& seen, const Blockers& blockers);

  /// The line through a point of the light, above the horizons of the surface and of its shading
  /// normal.
  LightLine through(const Vec2& place) const;
  /// An estimate of the mean from one line, when `mean` is that of the light were it not hidden.
  double cosine(const LightLine& line, const VisibleParts& parts, double mean) const;

 private:
  const ShadingPoint& point_;
  const SeenLight& seen_;
  bool one_horizon_;
  double beta_ = 0.0;
};

}  // namespace rt
