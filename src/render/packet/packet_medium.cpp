#include "rt/render/packet/packet_medium.h"

#include "rt/render/medium.h"

namespace rt {

unsigned find_media(const RenderPlan& plan, std::uint32_t id, const WideShadingPoint& point,
                    const Wide3& direction, unsigned bits, WideMedia& media) {
  const std::span<const std::uint32_t> candidates = plan.media_about(id);
  if (candidates.size() == 1 && candidates[0] == id) {
    // The usual case: nothing transmissive is near but the solid itself.
    const Wide ior = plan.material_of(plan.instances[id]).ior;
    const WideMask here = mask_of(bits);
    const WideMask from_outside = mask_of(point.from_outside);
    media.n1 = select(here, select(from_outside, Wide(1.0), ior), media.n1);
    media.n2 = select(here, select(from_outside, ior, Wide(1.0)), media.n2);
    if (plan.absorbs) {
      each_lane(bits & ~point.from_outside,
                [&](int i) { media.before[static_cast<std::size_t>(i)] = id; });
    }
    return 0;
  }
  unsigned displaced = 0;
  each_lane(bits, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    const Media one = media_about(plan, point.lane(i), direction.lane(i));
    displaced |= static_cast<unsigned>(hides(plan, one, id)) << i;
    media.before[at] = one.before;
    media.n1[at] = index_of(plan, one.before);
    media.n2[at] = index_of(plan, one.behind);
  });
  return displaced;
}

void find_medium_before(const RenderPlan& plan, std::uint32_t id, const WideShadingPoint& point,
                        const Wide3& direction, unsigned bits, WideMedia& media) {
  if (plan.media_about(id).empty()) {
    return;
  }
  each_lane(bits, [&](int i) {
    media.before[static_cast<std::size_t>(i)] =
        medium_ahead(plan, point.lane(i), -direction.lane(i));
  });
}

void absorb(const RenderPlan& plan, const WideMedia& media, const Wide& t, unsigned bits,
            Wide3& throughput) {
  each_lane(bits & ~lanes_where(media.before, no_instance), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    throughput.set(i, throughput.lane(i) * transmittance(plan, media.before[at], t[at]));
  });
}

void absorb_beyond(const RenderPlan& plan, const Packet& packet, unsigned bits, Wide3& throughput) {
  each_lane(bits, [&](int i) {
    throughput.set(i, throughput.lane(i) * transmittance_beyond(plan, packet.lane(i)));
  });
}

}  // namespace rt
