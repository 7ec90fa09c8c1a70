#pragma once
/// What the rays of a packet may cross, found together.
#include "rt/render/accel/box_list.h"
#include "rt/render/accel/box_tree.h"
#include "rt/render/accel/grid.h"
#include "rt/render/packet/packet.h"
#include "rt/render/plan.h"

namespace rt {

/// A packet in the space of the boxes.
class PacketBoxRays {
 public:
  /// Lanes that pass all boxes by are taken out.
  PacketBoxRays(const BoxSpace& space, const Packet& packet, const Wide& t_max) {
    each_lane(packet.active, [&](int i) {
      if (space.enter(packet.ray.lane(i), rays_[static_cast<std::size_t>(i)])) {
        active_ |= 1U << i;
      }
    });
    limit(t_max);
  }

  unsigned active() const { return active_; }

  /// Where lanes end from now on; those with a negative t_max leave.
  void limit(const Wide& t_max) {
    each_lane(active_, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      limits_[at] = t_max[at] < 0.0 ? -1.0F : rays_[at].limit(t_max[at]);
    });
  }
  /// Which lanes of `bits` do not end before the float parameter.
  unsigned before_end(unsigned bits, float near) const {
    unsigned out = 0;
    each_lane(bits, [&](int i) {
      out |= static_cast<unsigned>(!(near > limits_[static_cast<std::size_t>(i)])) << i;
    });
    return out;
  }

  /// Which boxes of the group the lanes of `bits` may touch: per_box[b] are the lanes that may
  /// touch box b, near[b] is where the first of them enters. Returns the boxes.
  unsigned touched(const BoxGroup& group, unsigned bits, unsigned* per_box, float* near) const {
    unsigned boxes = 0;
    for (std::size_t b = 0; b < BoxGroup::width; ++b) {
      per_box[b] = 0;
    }
    __m256 nearest = _mm256_set1_ps(std::numeric_limits<float>::infinity());
    each_lane(bits, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      alignas(32) float enter[BoxGroup::width];
      const unsigned hits = group.touched(rays_[at], limits_[at], enter);
      boxes |= hits;
      for (unsigned rest = hits; rest != 0; rest &= rest - 1) {
        per_box[std::countr_zero(rest)] |= 1U << i;
      }
      nearest = _mm256_min_ps(nearest, _mm256_load_ps(enter));
    });
    _mm256_store_ps(near, nearest);
    return boxes;
  }

 private:
  std::array<BoxRay, lanes> rays_;
  std::array<float, lanes> limits_{};
  unsigned active_ = 0;
};

/// Calls visit(index, lanes) -> Wide for every box of a list that lanes may touch; what it returns
/// is the lanes' new t_max.
template <class Visit>
void walk_packet(const BoxList& list, const Packet& packet, const Wide& t_max, Visit&& visit) {
  PacketBoxRays rays(list.space(), packet, t_max);
  const auto& groups = list.groups();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    unsigned per_box[BoxGroup::width];
    alignas(32) float near[BoxGroup::width];
    for (unsigned hits = rays.touched(groups[g], rays.active(), per_box, near); hits != 0;) {
      const int box = BoxGroup::nearest(hits, near);
      hits &= ~(1U << box);
      if (const unsigned bits = rays.before_end(per_box[box], near[box])) {
        rays.limit(visit(static_cast<std::uint32_t>(BoxGroup::width * g) +
                             static_cast<std::uint32_t>(box),
                         bits));
      }
    }
  }
}

/// The same for a hierarchy.
template <class Visit>
void walk_packet(const BoxTree& tree, const Packet& packet, const Wide& t_max, Visit&& visit) {
  PacketBoxRays rays(tree.space(), packet, t_max);
  tree.walk_together(rays, visit);
}

/// Calls visit(instance, lanes) -> Wide for all that lanes of the packet may cross before t_max;
/// what it returns is their new t_max, negative where a lane's search has ended.
template <class Visit>
void each_candidate(const RenderPlan& plan, const Packet& packet, Wide t_max, Visit visit) {
  for (const std::uint32_t id : plan.unbounded) {
    t_max = visit(id, packet.active);
  }
  const auto visit_box = [&](std::uint32_t index, unsigned bits) {
    return visit(plan.bounded[index], bits);
  };
  if (plan.list) {
    walk_packet(*plan.list, packet, t_max, visit_box);
  } else if (plan.tree) {
    walk_packet(*plan.tree, packet, t_max, visit_box);
  } else if (plan.grid) {
    each_lane(packet.active, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      if (!(t_max[at] < 0.0)) {
        plan.grid->walk(packet.ray.lane(i), t_max[at], [&](std::uint32_t index) {
          t_max = visit_box(index, 1U << i);
          return double{t_max[at]};
        });
      }
    });
  } else {
    for (std::uint32_t index = 0; index < plan.bounded.size(); ++index) {
      visit_box(index, packet.active);
    }
  }
}

}  // namespace rt
