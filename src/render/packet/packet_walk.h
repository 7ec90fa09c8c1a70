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
  using Floats = stdx::rebind_simd_t<float, Wide>;

 public:
  /// Rays whose directions are unit vectors; those that pass all boxes by are taken out. t counts
  /// `length`s.
  PacketBoxRays(const BoxSpace& space, const WideRay& ray, unsigned active, const Wide& t_max,
                const Wide& length = 1.0) {
    const Wide per_unit = space.per_unit();
    per_t_ = per_unit * length;
    const Wide3 origin = (ray.origin - Wide3(space.centre())) * per_unit;
    const unsigned near = bits_of(max_abs(origin) < BoxSpace::reach_of_rays) & active;
    const Wide3& d = ray.direction;
    const Wide3 inverse{inverse_of(d.x), inverse_of(d.y), inverse_of(d.z)};
    active_ = near;
    for (std::size_t i = 0; i < lanes; ++i) {
      rays_[i].origin = {static_cast<float>(origin.x[i]), static_cast<float>(origin.y[i]),
                         static_cast<float>(origin.z[i])};
      rays_[i].inverse = {static_cast<float>(inverse.x[i]), static_cast<float>(inverse.y[i]),
                          static_cast<float>(inverse.z[i])};
    }
    each_lane(active & ~near, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      if (space.enter(ray.lane(i), rays_[at])) {
        active_ |= 1U << i;
        entry_[at] = rays_[at].entry;
      }
    });
    limit(t_max);
  }

  unsigned active() const { return active_; }

  /// Where lanes end from now on; those with a negative t_max leave.
  void limit(const Wide& t_max) {
    const auto far = stdx::static_simd_cast<Floats>(t_max * per_t_ - entry_);
    // As BoxRay::beyond_rounding().
    limits_ = far + stdx::abs(far) * 0x1p-20F + 0x1p-17F;
    ended_ = bits_of(t_max < 0.0);
  }
  /// Whether all have left.
  bool ended() const { return (active_ & ~ended_) == 0; }
  /// Which lanes of `bits` do not end before the float parameter.
  unsigned before_end(unsigned bits, float near) const {
    const Floats::mask_type before = !(limits_ < near);
    return static_cast<unsigned>(before.__to_bitset().to_ulong()) & bits & ~ended_;
  }

  /// What the lanes may touch of a group of boxes.
  struct Touched {
    unsigned boxes = 0;                       ///< that some lane may touch
    std::uint64_t by_lane = 0;                ///< byte i: the boxes that lane i may
    alignas(32) float near[BoxGroup::width];  ///< where the first lane enters, or earlier

    /// Bit `box` of every byte, side by side: the product moves that of byte i to bit 56 + i, and no
    /// two to the same place.
    unsigned lanes_at(int box) const {
      static_assert(lanes <= 8 && BoxGroup::width == 8);
      const std::uint64_t bits = by_lane >> box & 0x0101010101010101U;
      return static_cast<unsigned>(bits * 0x0102040810204080U >> 56);
    }
  };
  Touched touched(const BoxGroup& group, unsigned bits) const {
    Touched out;
    BoxGroup::Floats nearest = std::numeric_limits<float>::infinity();
    each_lane(bits, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      BoxGroup::Floats near;
      const unsigned boxes = group.touched(rays_[at], float{limits_[at]}, near);
      out.by_lane |= std::uint64_t{boxes} << (8 * i);
      out.boxes |= boxes;
      nearest = min(nearest, near);
    });
    nearest.copy_to(out.near, stdx::vector_aligned);
    return out;
  }

 private:
  /// As BoxSpace::inverse_of().
  static Wide inverse_of(const Wide& d) {
    return select(abs(d) * BoxSpace::endless > 1.0, 1.0 / d,
                  stdx::copysign(Wide(BoxSpace::endless), d));
  }

  std::array<BoxRay, lanes> rays_;
  Floats limits_{0.0F};
  Wide per_t_{0.0};
  Wide entry_{0.0};
  unsigned active_ = 0;
  unsigned ended_ = 0;
};

/// Calls visit(index, lanes) -> const Wide* for every box of a list that lanes may touch; what it
/// returns is the lanes' new t_max, null where it is the old one.
template <class Visit>
void walk_packet(const BoxList& list, const Packet& packet, const Wide& t_max, Visit&& visit) {
  PacketBoxRays rays(list.space(), packet.ray, packet.active, t_max);
  const auto& groups = list.groups();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto touched = rays.touched(groups[g], rays.active());
    for (unsigned hits = touched.boxes; hits != 0;) {
      const int box = BoxGroup::nearest(hits, touched.near);
      hits &= ~(1U << box);
      if (const unsigned bits = rays.before_end(touched.lanes_at(box), touched.near[box])) {
        const auto index = static_cast<std::uint32_t>(BoxGroup::width * g) +
                           static_cast<std::uint32_t>(box);
        if (const Wide* shorter = visit(index, bits)) {
          rays.limit(*shorter);
        }
      }
    }
  }
}

/// The same for a hierarchy.
template <class Visit>
void walk_packet(const BoxTree& tree, const Packet& packet, const Wide& t_max, Visit&& visit) {
  PacketBoxRays rays(tree.space(), packet.ray, packet.active, t_max);
  tree.walk_together(rays, visit);
}

/// Calls visit(instance, lanes) -> const Wide* for all that lanes of the packet may cross before
/// t_max; what it returns is their new t_max, negative where a lane's search has ended; null where it
/// is the old one.
template <class Visit>
void each_candidate(const RenderPlan& plan, const Packet& packet, Wide t_max, Visit visit) {
  for (const std::uint32_t id : plan.unbounded()) {
    if (const Wide* shorter = visit(id, packet.active)) {
      t_max = *shorter;
    }
  }
  if (plan.list) {
    walk_packet(*plan.list, packet, t_max, visit);
  } else if (plan.tree) {
    walk_packet(*plan.tree, packet, t_max, visit);
  } else if (plan.grid) {
    each_lane(packet.active, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      if (!(t_max[at] < 0.0)) {
        plan.grid->walk(packet.ray.lane(i), t_max[at], [&](std::uint32_t id) {
          if (const Wide* shorter = visit(id, 1U << i)) {
            t_max = *shorter;
          }
          return double{t_max[at]};
        });
      }
    });
  } else {
    for (std::uint32_t id = 0; id < plan.bounded; ++id) {
      visit(id, packet.active);
    }
  }
}

}  // namespace rt
