#pragma once
/// The two questions asked of a scene (query.h), for packets of rays. What moves is asked one by one.
/// Every lane gets the answer that its ray alone would get, bit for bit.
#include <span>

#include "rt/render/packet/packet.h"
#include "rt/render/plan.h"

namespace rt {

PacketHits closest_hits(const RenderPlan& plan, const Packet& packet);

/// The same, when only these instances can be crossed.
PacketHits closest_hits_among(const RenderPlan& plan, std::span<const std::uint32_t> instances,
                              const Packet& packet);

/// The lanes of `active` whose rays something that blocks shadow rays crosses with 0 < t <= t_max.
/// `last` becomes what was found last, if something was.
unsigned occluded_lanes(const RenderPlan& plan, const Packet& packet, const Wide& t_max,
                        std::uint32_t& last);
/// What may block some of the lanes.
struct Blocker {
  std::uint32_t instance;
  unsigned bits;  ///< of its lanes
};
/// The same, when only these can, each in its own lanes.
unsigned occluded_lanes_by(const RenderPlan& plan, std::span<const Blocker> blockers,
                           const Packet& packet, const Wide& t_max);

/// The lanes that have left that instance and cannot meet it again.
unsigned gone_for_good(const RenderPlan& plan, std::uint32_t instance, const Ids& left,
                       unsigned outward);

}  // namespace rt
