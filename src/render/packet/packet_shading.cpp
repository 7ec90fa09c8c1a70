#include "rt/render/packet/packet_shading.h"

#include "rt/math/rounding.h"
#include "wide_maps.h"

namespace rt {

ShadingPoint WideShadingPoint::lane(int i) const {
  const auto at = static_cast<std::size_t>(i);
  ShadingPoint p;
  p.position = position.lane(i);
  p.normal = normal.lane(i);
  p.shading_normal = shading_normal.lane(i);
  p.side = (from_outside >> i & 1U) != 0 ? Leaving::outward : Leaving::inward;
  p.position_error = position_error[at];
  p.instance = instance[at];
  p.feature = static_cast<std::uint32_t>(feature[at]);
  p.time = time != nullptr ? (*time)[at] : 0.0;
  p.footprint = footprint[at];
  return p;
}

void WideShadingPoint::set(int i, const ShadingPoint& p) {
  const auto at = static_cast<std::size_t>(i);
  position.set(i, p.position);
  normal.set(i, p.normal);
  shading_normal.set(i, p.shading_normal);
  from_outside = (from_outside & ~(1U << i)) | static_cast<unsigned>(p.side == Leaving::outward)
                                                   << i;
  position_error[at] = p.position_error;
  feature[at] = p.feature;
}

namespace {

template <class S, class Map>
WideShadingPoint point_on(const S& shape, const Map& map, const Packet& packet,
                          const PacketHits& hits) {
  const WideRay ray = model_rays(map, packet.ray);
  const WideSurfacePoint p = surface_point(shape, ray, hits.t, hits.feature);
  WideShadingPoint point;
  point.position = render_points(map, p.position);
  point.position_error =
      gamma(16) * (map.render_per_model() * max_abs(p.position) + Wide(max_abs(map.offset)));
  const Wide3 normal = render_normals(map, p.normal);
  const WideMask from_outside = dot(p.normal, ray.direction) <= 0.0;
  point.normal = select(from_outside, normal, -normal);
  point.shading_normal = point.normal;
  point.from_outside = bits_of(from_outside);
  return point;
}

/// The hits of those lanes of `bits`, all of instance `id`.
WideShadingPoint points_of_one(const RenderPlan& plan, const Packet& packet,
                               const PacketHits& hits, std::uint32_t id, unsigned bits) {
  const PlannedInstance& instance = plan.instances[id];
  return plan.visit(instance, [&](const auto& shape) {
    if constexpr (WideShape<std::decay_t<decltype(shape)>>) {
      if (!instance.moves()) {
        return plan.map(instance, 0.0,
                        [&](const auto& map) { return point_on(shape, map, packet, hits); });
      }
    }
    WideShadingPoint one_by_one{};
    each_lane(bits, [&](int i) {
      one_by_one.set(i, shading_point(plan, packet.lane(i), hits.lane(i)));
    });
    return one_by_one;
  });
}

/// Takes the lanes of `bits` from `other`.
void take(WideShadingPoint& points, const WideShadingPoint& other, unsigned bits) {
  const WideMask mask = mask_of(bits);
  points.position = select(mask, other.position, points.position);
  points.normal = select(mask, other.normal, points.normal);
  points.shading_normal = select(mask, other.shading_normal, points.shading_normal);
  points.position_error = select(mask, other.position_error, points.position_error);
  points.from_outside = (points.from_outside & ~bits) | (other.from_outside & bits);
}

}  // namespace

WideShadingPoint shading_points(const RenderPlan& plan, const Packet& packet,
                                const PacketHits& hits, unsigned bits) {
  const std::uint32_t first = hits.instance[static_cast<std::size_t>(std::countr_zero(bits))];
  const unsigned same = lanes_where(hits.instance, first) & bits;
  WideShadingPoint points = points_of_one(plan, packet, hits, first, same);
  each_instance(hits.instance, bits & ~same, [&](std::uint32_t id, unsigned next) {
    take(points, points_of_one(plan, packet, hits, id, next), next);
  });
  points.instance = hits.instance;
  points.feature = hits.feature;
  points.time = packet.time;
  return points;
}

Packet leave(const WideShadingPoint& from, const Wide3& direction, unsigned bits) {
  const unsigned to_seen_side = bits_of(dot(from.normal, direction) >= 0.0);
  return {{from.position, direction},
          bits,
          from.position_error,
          true,
          from.instance,
          from.feature,
          ~(to_seen_side ^ from.from_outside) & all_lanes,
          from.time};
}

}  // namespace rt
