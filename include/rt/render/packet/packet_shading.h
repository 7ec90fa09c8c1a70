#pragma once
/// Points to be shaded, several at a time: shading.h and direct_light.h lane by lane.
#include "rt/math/wide_sampler.h"
#include "rt/render/direct_light.h"
#include "rt/render/packet/packet.h"

namespace rt {

/// As ShadingPoint, with an instance for each lane.
struct WideShadingPoint {
  Wide3 position;
  Wide3 normal, shading_normal;
  unsigned from_outside = 0;  ///< lanes whose ray came from the outer side
  Wide position_error;
  Ids instance{no_instance};
  Wide feature;
  Wide footprint{0.0};
  const Wide* time = nullptr;  ///< of the rays that found them, where something moves

  ShadingPoint lane(int i) const;
  void set(int i, const ShadingPoint& point);
};

/// The hits of those lanes of `bits`.
WideShadingPoint shading_points(const RenderPlan& plan, const Packet& packet,
                                const PacketHits& hits, unsigned bits);

/// Rays from those lanes, which know what they leave and to which side.
Packet leave(const WideShadingPoint& from, const Wide3& direction, unsigned bits);

/// As Phong, textures resolved in every lane.
struct WidePhong {
  Wide3 kd, ks;
  Wide shininess;
  Wide least_r_dot_v;
};

/// Light `index` reflected towards `view`; 0 in lanes that are not of `bits`. `cells`: where the
/// points are, as the cache numbers it.
Wide3 direct_light(const RenderPlan& plan, std::size_t index, const WidePhong& phong,
                   const WideShadingPoint& point, unsigned bits, const Wide& cells,
                   const Wide3& view, const WideSampler& sampler, const Vertex& vertex, const Wide& negligible,
                   ShadowCache& cache, RayCounts& counts);

}  // namespace rt
