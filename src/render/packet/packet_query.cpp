#include "rt/render/packet/packet_query.h"

#include <algorithm>

#include "packet_walk.h"
#include "rt/math/rounding.h"
#include "rt/render/query.h"
#include "wide_maps.h"

namespace rt {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// How far the origins may be from what they stand for, in the model; nothing for camera rays. As
/// for a single ray: query.cpp.
template <class Map>
Wide error_in_model(const Map& map, const Packet& packet) {
  if (!packet.from_surface) {
    return 0.0;
  }
  const double stretch = map.model_per_render();
  const Wide reach = stretch * max_abs(packet.ray.origin) + Wide(map.model_offset());
  return stretch * packet.position_error + gamma(Map::roundings) * reach;
}

/// The lanes that may cross the instance's box.
WideMask meet_box(const RenderPlan& plan, const PlannedInstance& instance, const Packet& packet,
                  const Wide& t_max) {
  return plan.map(instance, 0.0, [&](const auto& map) {
    return may_meet(model_box_of(plan, instance), model_rays(map, packet.ray), t_max,
                    error_in_model(map, packet));
  });
}

/// What is left to be asked one by one.
WideHit undecided_in(const WideMask& lanes_left) {
  return {WideMask(false), lanes_left, Wide(0.0), Wide(0.0)};
}

/// The crossings of lanes that start elsewhere. Not inlined: see below.
[[gnu::noinline]] WideHit meet(const RenderPlan& plan, const PlannedInstance& instance,
                               const Packet& packet, const Wide& t_max) {
  return plan.visit(instance, [&](const auto& shape) -> WideHit {
    if constexpr (WideShape<std::decay_t<decltype(shape)>>) {
      return plan.map(instance, 0.0, [&](const auto& map) {
        return intersect(shape, model_rays(map, packet.ray), t_max, error_in_model(map, packet));
      });
    } else {
      return undecided_in(meet_box(plan, instance, packet, t_max));
    }
  });
}

/// The crossings of the instance that the lanes have left.
WideHit meet_again(const RenderPlan& plan, const PlannedInstance& instance, const Packet& packet,
                   const Wide& t_max) {
  if (instance.is<Sphere>()) {
    WideHit again = plan.map(instance, 0.0, [&](const auto& map) {
      return leave_inward(plan.shapes.of<Sphere>()[instance.shape], model_rays(map, packet.ray),
                          t_max);
    });
    again.hit = again.hit && !mask_of(packet.outward);
    return again;
  }
  unsigned gone = instance.convex ? packet.outward : 0;
  if (instance.is<Torus>() && packet.outward != 0) {
    gone = plan.map(instance, 0.0, [&](const auto& map) {
      return bits_of(leaves_for_good(plan.shapes.of<Torus>()[instance.shape],
                                     model_rays(map, packet.ray)));
    });
    gone &= packet.outward;
  }
  return undecided_in(mask_of(~gone & all_lanes));
}

/// The triangles of a mesh that lanes cross first, or any.
class MeshSearch {
 public:
  MeshSearch(const MeshData& mesh, const WideRay& ray, const Packet& packet, const Wide& error,
             unsigned again, const Wide& t_max, bool any)
      : mesh_(mesh),
        ray_(ray),
        packet_(packet),
        error_(error),
        again_(again),
        any_(any),
        limit_(t_max),
        t_(t_max) {}

  WideHit walk(const BoxTree& tree, unsigned bits) {
    const Wide size = length(ray_.direction);
    PacketBoxRays rays(tree.space(), {ray_.origin, ray_.direction * (1.0 / size)},
                       bits & bits_of(size > 0.0), limit_, size);
    const auto visit = [&](std::uint32_t triangle, unsigned lanes_there) {
      return meet(triangle, lanes_there) ? &limit_ : nullptr;
    };
    tree.walk_together(rays, visit);
    return {mask_of(found_), WideMask(false), t_, feature_};
  }

 private:
  /// Whether that shortens a search.
  bool meet(std::uint32_t triangle, unsigned bits) {
    unsigned hits = 0;
    each_lane(bits & ~bits_of(passes_by(mesh_, triangle, ray_)), [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      const OptionalHit hit =
          intersect_triangle(mesh_, triangle, ray_.lane(i), t_[at], start_of(i));
      // Equal t: the lower index wins, whatever the order of the walk.
      const bool first = (found_ >> i & 1U) == 0;
      if (hit && (first || hit->t < t_[at] || triangle < feature_[at])) {
        hits |= 1U << i;
        t_[at] = hit->t;
        feature_[at] = triangle;
        limit_[at] = any_ ? -1.0 : hit->t;
      }
    });
    found_ |= hits;
    return hits != 0;
  }

  RayStart start_of(int i) const {
    const auto at = static_cast<std::size_t>(i);
    RayStart start{.position_error = error_[at]};
    if ((again_ >> i & 1U) != 0) {
      start.leaving = (packet_.outward >> i & 1U) != 0 ? Leaving::outward : Leaving::inward;
      start.feature = static_cast<std::uint32_t>(packet_.feature[at]);
    }
    return start;
  }

  const MeshData& mesh_;
  const WideRay& ray_;
  const Packet& packet_;
  const Wide& error_;
  unsigned again_;
  bool any_;
  Wide limit_;
  Wide t_;
  Wide feature_{0.0};
  unsigned found_ = 0;
};

/// The crossings of a mesh with a hierarchy in the lanes of `bits`, none undecided; `any`: not the
/// nearest. `again`: the lanes that have left it.
WideHit meet_mesh(const RenderPlan& plan, const PlannedInstance& instance, const Packet& packet,
                  unsigned bits, unsigned again, const Wide& t_max, bool any) {
  const MeshData& mesh = *plan.shapes.of<Mesh>()[instance.shape].data;
  const BoxTree& tree = *plan.mesh_trees[instance.shape];
  return plan.map(instance, 0.0, [&](const auto& map) {
    const WideRay ray = model_rays(map, packet.ray);
    const Wide error = error_in_model(map, packet);
    return MeshSearch(mesh, ray, packet, error, again, t_max, any).walk(tree, bits);
  });
}

/// Asks the lanes of `bits` one by one where the answer is undecided.
[[gnu::always_inline]] inline void decide(const RenderPlan& plan, std::uint32_t id,
                                          const Packet& packet, unsigned bits, const Wide& t_max,
                                          WideHit& found) {
  unsigned hit = bits_of(found.hit) & bits;
  const unsigned undecided = bits_of(found.undecided) & bits;
  if (undecided != 0) {
    each_lane(undecided, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      if (const auto one = instance_hit(plan, id, packet.lane(i), t_max[at])) {
        hit |= 1U << i;
        found.t[at] = one->t;
        found.feature[at] = one->feature;
      }
    });
  }
  found.hit = mask_of(hit);
}

/// Of a mesh, which is searched, and of what moves, which is elsewhere for every lane. Not inlined:
/// it would make the way of all others longer (bench/NOTES.md).
[[gnu::noinline]] WideHit crossings_of_mesh_or_moving(const RenderPlan& plan, std::uint32_t id,
                                                      const Packet& packet, unsigned bits,
                                                      const Wide& t_max, bool any) {
  const PlannedInstance& instance = plan.instances[id];
  const unsigned again = packet.from_surface ? lanes_where(packet.instance, id) & bits : 0;
  if (!instance.moves() && plan.mesh_trees[instance.shape] && std::popcount(bits) > 1) {
    return meet_mesh(plan, instance, packet, bits, again, t_max, any);
  }
  const unsigned near =
      instance.moves() ? bits : bits_of(meet_box(plan, instance, packet, t_max)) | again;
  WideHit found = undecided_in(
      mask_of(near & ~gone_for_good(plan, id, packet.instance, packet.outward)));
  decide(plan, id, packet, bits, t_max, found);
  return found;
}

/// Of all else.
WideHit crossings_of_still(const RenderPlan& plan, std::uint32_t id, const Packet& packet,
                           unsigned bits, const Wide& t_max) {
  const PlannedInstance& instance = plan.instances[id];
  const unsigned again = packet.from_surface ? lanes_where(packet.instance, id) & bits : 0;
  WideHit found = again == bits ? meet_again(plan, instance, packet, t_max)
                                : meet(plan, instance, packet, t_max);
  if (again != 0 && again != bits) {
    const WideMask left = mask_of(again);
    const WideHit next = meet_again(plan, instance, packet, t_max);
    found.hit = (found.hit && !left) || (next.hit && left);
    found.undecided = (found.undecided && !left) || (next.undecided && left);
    found.t = select(left, next.t, found.t);
    found.feature = select(left, next.feature, found.feature);
  }
  decide(plan, id, packet, bits, t_max, found);
  return found;
}

/// The crossings of those lanes of the packet that are in `bits`, the nearest or any; none is left
/// undecided.
WideHit crossings(const RenderPlan& plan, std::uint32_t id, const Packet& packet, unsigned bits,
                  const Wide& t_max, bool any = false) {
  const PlannedInstance& instance = plan.instances[id];
  return instance.is<Mesh>() || instance.moves()
             ? crossings_of_mesh_or_moving(plan, id, packet, bits, t_max, any)
             : crossings_of_still(plan, id, packet, bits, t_max);
}

/// Keeps each lane's winner among the crossings offered: as Nearest in query.cpp.
class WideNearest {
 public:
  WideNearest(const RenderPlan& plan, const Packet& packet)
      : plan_(plan), origin_(max_abs(packet.ray.origin)) {}

  const Wide& limit() const { return limit_; }

  void offer(std::uint32_t id, const WideHit& crossing) {
    const Wide t = select(crossing.hit, crossing.t, Wide(inf));
    const WideMask nearer = t < nearest_;
    nearest_ = select(nearer, t, nearest_);
    limit_ = select(nearer, min(limit_, t + tie * (t + origin_)), limit_);
    const double rank = rank_of(plan_.instances[id]);
    const WideMask wins = crossing.hit && (t_ > limit_ || rank < rank_);
    t_ = select(wins, t, t_);
    rank_ = select(wins, Wide(rank), rank_);
    id_ = select(wins, Wide(1.0 * id), id_);
    feature_ = select(wins, crossing.feature, feature_);
  }

  PacketHits hits() const { return {t_, feature_, stdx::static_simd_cast<Ids>(id_)}; }

 private:
  /// As PlannedInstance::precedes(): the least rank.
  static double rank_of(const PlannedInstance& instance) {
    return (instance.clear ? 0x1p32 : 0.0) + instance.order;
  }

  const RenderPlan& plan_;
  Wide origin_;
  Wide nearest_{inf};
  Wide limit_{inf};
  Wide t_{inf};
  Wide rank_{inf};
  Wide id_{1.0 * no_instance};
  Wide feature_{0.0};
};

/// Lanes whose ray may block for instance `id`.
bool may_block(const PlannedInstance& instance) { return instance.shadow == Shadow::blocks; }

}  // namespace

PacketHits closest_hits(const RenderPlan& plan, const Packet& packet) {
  WideNearest nearest(plan, packet);
  each_candidate(plan, packet, Wide(inf), [&](std::uint32_t id, unsigned bits) -> const Wide* {
    const WideHit crossing = crossings(plan, id, packet, bits, nearest.limit());
    if (!any(crossing.hit)) {
      return nullptr;
    }
    nearest.offer(id, crossing);
    return &nearest.limit();
  });
  return nearest.hits();
}

PacketHits closest_hits_among(const RenderPlan& plan, std::span<const std::uint32_t> instances,
                              const Packet& packet) {
  WideNearest nearest(plan, packet);
  for (const std::uint32_t id : instances) {
    nearest.offer(id, crossings(plan, id, packet, packet.active, nearest.limit()));
  }
  return nearest.hits();
}

unsigned occluded_lanes(const RenderPlan& plan, const Packet& packet, const Wide& t_max,
                        std::uint32_t& last) {
  unsigned found = 0;
  Wide limit = t_max;
  each_candidate(plan, packet, t_max, [&](std::uint32_t id, unsigned bits) -> const Wide* {
    bits &= ~(found | gone_for_good(plan, id, packet.instance, packet.outward));
    if (bits != 0 && may_block(plan.instances[id])) {
      if (const unsigned hit = bits_of(crossings(plan, id, packet, bits, t_max, true).hit)) {
        found |= hit;
        last = id;
        limit = select(mask_of(found), Wide(-1.0), t_max);
        return &limit;
      }
    }
    return nullptr;
  });
  return found & packet.active;
}

unsigned occluded_lanes_by(const RenderPlan& plan, std::span<const Blocker> blockers,
                           const Packet& packet, const Wide& t_max) {
  unsigned found = 0;
  for (const auto& [id, bits] : blockers) {
    const unsigned open = bits & ~found;
    if (open != 0 && may_block(plan.instances[id])) {
      found |= bits_of(crossings(plan, id, packet, open, t_max, true).hit);
    }
  }
  return found;
}

unsigned gone_for_good(const RenderPlan& plan, std::uint32_t instance, const Ids& left,
                       unsigned outward) {
  return plan.instances[instance].convex ? lanes_where(left, instance) & outward : 0;
}

}  // namespace rt
