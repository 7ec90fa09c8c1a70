#pragma once
/// surface_texture.h for packets.
#include "rt/render/packet/packet_footprint.h"

namespace rt {

/// As Reflectances.
struct WideReflectances {
  Wide3 kd, ks;
  Wide opacity;
};

/// Those of the lanes of `bits`, all on instance `id`: what textured() says of each; the other lanes
/// hold nothing. `here`: null where textures are not filtered.
WideReflectances textured(const RenderPlan& plan, const Packet& packet, const PacketHits& hits,
                          std::uint32_t id, unsigned bits, const WideRayDifferential* here,
                          WideShadingPoint& point);

}  // namespace rt
