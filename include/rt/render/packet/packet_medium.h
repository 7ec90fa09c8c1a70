#pragma once
/// medium.h for packets.
#include "rt/render/packet/packet_shading.h"

namespace rt {

/// What lies on the two sides of surfaces.
struct WideMedia {
  Wide n1{1.0}, n2{1.0};    ///< indices before and behind what is transmissive; else 1
  Ids before{no_instance};  ///< the medium before; only known where some medium absorbs
};

/// Finds the media about the surface of a transmissive instance `id` in the lanes of `bits`. Returns
/// the lanes where another one displaces its own: hides().
unsigned find_media(const RenderPlan& plan, std::uint32_t id, const WideShadingPoint& point,
                    const Wide3& direction, unsigned bits, WideMedia& media);

/// Finds the medium before the surface of an opaque instance.
void find_medium_before(const RenderPlan& plan, std::uint32_t id, const WideShadingPoint& point,
                        const Wide3& direction, unsigned bits, WideMedia& media);

/// Takes what the media before absorb over the distances t.
void absorb(const RenderPlan& plan, const WideMedia& media, const Wide& t, unsigned bits,
            Wide3& throughput);

/// Takes what is absorbed from lanes that meet nothing.
void absorb_beyond(const RenderPlan& plan, const Packet& packet, unsigned bits, Wide3& throughput);

}  // namespace rt
