#pragma once
/// footprint.h for packets: what the differential of each lane's ray is, bit for bit.
#include <vector>

#include "rt/render/footprint.h"
#include "rt/render/packet/packet_shading.h"

namespace rt {

using WideRayDifferential = RayDifferentialOf<Wide3>;
using WideNormalDifferential = NormalDifferentialOf<Wide3>;

inline RayDifferential lane_of(const WideRayDifferential& all, int i) {
  return {all.dp_dx.lane(i), all.dp_dy.lane(i), all.dd_dx.lane(i), all.dd_dy.lane(i)};
}

/// The differentials of a packet tracer's open paths, in the order of its stack.
class PacketFootprints {
 public:
  explicit PacketFootprints(const RenderPlan& plan);

  /// Camera rays, not normalised, become the only open paths. `time`: theirs, or null.
  void begin(const WideRay& camera_rays, unsigned active, const Wide* time);
  /// The paths that lie above `open` others meet surfaces at distances t.
  void arrive(std::size_t open, const Wide3& direction, const Wide& t, WideShadingPoint& point);
  /// At the surfaces just met.
  const WideRayDifferential& here() const { return here_; }
  /// The paths of `bits` go on from there, all to the side that their rays came from (`reflect`) or
  /// all through the surface. The rest as for FootprintTrail::branch().
  void branch(const WideShadingPoint& point, unsigned bits, const Wide3& incoming,
              const Wide3& direction, bool reflect, const Wide& eta, const PowerCosineLobe* lobe);

 private:
  const RenderPlan& plan_;
  double spacing_;
  std::vector<WideRayDifferential> open_;
  WideRayDifferential here_;
  WideNormalDifferential normal_;  ///< there, in the lanes that are known
  unsigned known_ = 0;
};

}  // namespace rt
