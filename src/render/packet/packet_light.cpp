#include <algorithm>
#include <array>
#include <cmath>

#include "rt/math/rounding.h"
#include "rt/math/wide_functions.h"
#include "rt/render/packet/packet_query.h"
#include "rt/render/packet/packet_shading.h"

namespace rt {
namespace {

/// As LightSample.
struct WideLightSample {
  Wide3 direction;
  Wide distance;
};

Wide falloff(const Light& light, const Wide& distance) {
  const auto& f = light.falloff;
  if (f.c1 == 0.0 && f.c2 == 0.0) {
    return 1.0 / f.c0;
  }
  return 1.0 / (f.c0 + distance * (f.c1 + distance * f.c2));
}

/// As for one point.
Wide3 relative_to(const Light& light, const WideShadingPoint& point) {
  return point.time == nullptr ? point.position
                               : point.position - *point.time * Wide3(light.travel);
}

WideLightSample sample_light(const Light& light, const WideShadingPoint& point) {
  WideLightSample out;
  const Wide3 to_light = Wide3(light.position) - relative_to(light, point);
  out.distance = length(to_light);
  out.direction = to_light * (1.0 / out.distance);
  return out;
}

bool is_black(const Wide3& c) { return !any(c.x != 0.0 || c.y != 0.0 || c.z != 0.0); }

Wide3 reflected(const WidePhong& phong, const WideShadingPoint& point, const Wide3& view,
                const Wide3& l, unsigned bits) {
  const Wide n_dot_l = dot(point.shading_normal, l);
  const WideMask lit = n_dot_l > 0.0 && dot(point.normal, l) > 0.0;
  Wide3 sum = phong.kd * n_dot_l;
  if (!is_black(phong.ks)) {
    const Wide r_dot_v = 2.0 * n_dot_l * dot(point.shading_normal, view) - dot(l, view);
    const unsigned shining =
        bits_of(lit && r_dot_v > phong.least_r_dot_v && max_abs(phong.ks) > 0.0) & bits;
    if (shining != 0) {
      Wide power(0.0);
      each_lane(shining, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        power[at] = std::pow(r_dot_v[at], phong.shininess[at]);
      });
      sum = select(mask_of(shining), sum + phong.ks * power, sum);
    }
  }
  return select(lit && mask_of(bits), sum, Wide3(Wide(0.0)));
}

/// What may block, each instance once, with its lanes.
class BlockersByLane {
 public:
  /// Adds some that may block the lanes of `bits`, of points lit on the side that `from` shows: none
  /// that a point lies on itself and that cannot hide anything from it.
  void add(const RenderPlan& plan, std::span<const std::uint32_t> instances,
           const WideShadingPoint& from, unsigned bits) {
    for (const std::uint32_t id : instances) {
      const unsigned open = bits & ~gone_for_good(plan, id, from.instance, from.from_outside);
      if (open != 0) {
        bits_of_one(id) |= open;
        open_ |= open;
      }
    }
  }
  unsigned open() const { return open_; }
  std::span<const Blocker> all() const { return {blockers_.data(), count_}; }

 private:
  unsigned& bits_of_one(std::uint32_t id) {
    const auto end = blockers_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto found =
        std::find_if(blockers_.begin(), end, [&](const Blocker& b) { return b.instance == id; });
    if (found == end) {
      *end = {id, 0};
      ++count_;
    }
    return found->bits;
  }

  std::array<Blocker, ShadowCache::most * lanes> blockers_;
  std::size_t count_ = 0;
  unsigned open_ = 0;
};

/// Asks the whole scene, but first for what has hidden all of the last packet: neighbours are often
/// hidden by the same (Haines and Greenberg, "The light buffer: a shadow-testing accelerator", 1986).
unsigned found_hidden(const RenderPlan& plan, Packet rays, const Wide& reach, std::uint32_t& last) {
  const unsigned all = rays.active;
  unsigned hidden = 0;
  if (last != no_instance) {
    const unsigned open = all & ~gone_for_good(plan, last, rays.instance, rays.outward);
    const Blocker blocker{last, open};
    hidden = occluded_lanes_by(plan, {&blocker, 1}, rays, reach);
  }
  rays.active = all & ~hidden;
  if (rays.active != 0) {
    hidden |= occluded_lanes(plan, rays, reach, last);
  }
  if (hidden != all) {
    last = no_instance;
  }
  return hidden;
}

/// The lanes of `bits`, all lit, that see the light in `direction` at `reach`; adds to `dimming`
/// those whose light may be dimmed.
unsigned seeing(const RenderPlan& plan, std::size_t index, const WideShadingPoint& from,
                unsigned bits, const Wide& cells, const Wide3& direction, const Wide& reach,
                ShadowCache& cache, unsigned& dimming) {
  unsigned hidden = 0;
  // A packet's way through a hierarchy costs less than keeping account of its cells; a list's boxes
  // are all tested by every search (bench/NOTES.md).
  unsigned unknown = plan.tree ? bits : 0;
  BlockersByLane blockers;
  for (unsigned rest = bits & ~unknown; rest != 0;) {
    const double cell = cells[static_cast<std::size_t>(std::countr_zero(rest))];
    const unsigned here = rest & bits_of(cells == cell);
    const Candidates candidates =
        cache.towards(index, static_cast<ShadowCache::Cell>(cell), std::popcount(here) > 1);
    rest &= ~here;
    if (!candidates.known) {
      unknown |= here;
      continue;
    }
    if (candidates.dims) {
      dimming |= here;
    }
    blockers.add(plan, candidates.instances, from, here);
  }
  if (blockers.open() != 0) {
    hidden |= occluded_lanes_by(plan, blockers.all(), leave(from, direction, blockers.open()),
                                reach);
  }
  if (unknown != 0) {
    hidden |= found_hidden(plan, leave(from, direction, unknown), reach, cache.last_blocker(index));
    dimming |= unknown;
  }
  return bits & ~hidden;
}

/// Extended lights are told of by lines (area_light.cpp), whose cases differ from lane to lane.
Wide3 one_by_one(const RenderPlan& plan, std::size_t index, const WidePhong& phong,
                 const WideShadingPoint& point, unsigned bits, const Wide3& view,
                 const WideSampler& sampler, const Vertex& vertex, const Wide& negligible,
                 ShadowCache& cache, RayCounts& counts) {
  Wide3 sum{Wide(0.0)};
  const WideSeenLight seen(relative_to(plan.lights[index], point), plan.lights[index]);
  each_lane(bits, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    const Phong one{phong.kd.lane(i), phong.ks.lane(i), phong.shininess[at],
                    phong.least_r_dot_v[at]};
    sum.set(i, direct_light(plan, index, seen.lane(i), one, point.lane(i), view.lane(i),
                            sampler.lane(i), vertex, negligible[at], cache, counts));
  });
  return sum;
}

}  // namespace

Wide3 direct_light(const RenderPlan& plan, std::size_t index, const WidePhong& phong,
                   const WideShadingPoint& point, unsigned bits, const Wide& cells,
                   const Wide3& view, const WideSampler& sampler, const Vertex& vertex,
                   const Wide& negligible, ShadowCache& cache, RayCounts& counts) {
  const PlannedLight& light = plan.lights[index];
  if (is_black(phong.kd) && is_black(phong.ks)) {
    return Wide3(Wide(0.0));
  }
  if (light.extended()) {
    return one_by_one(plan, index, phong, point, bits, view, sampler, vertex, negligible, cache,
                      counts);
  }
  const WideLightSample s = sample_light(light, point);
  Wide3 value = reflected(phong, point, view, s.direction, bits) * Wide3(light.colour) *
                falloff(light, s.distance);
  const unsigned matters = bits_of(max_abs(value) > negligible) & bits;
  unsigned seen = matters;
  unsigned dimming = 0;
  if (matters != 0) {
    // A surface through the light, as far as rounding can tell, does not shadow it.
    const Wide reach =
        s.distance - (point.position_error + gamma(4) * Wide(max_abs(light.position)));
    counts.shadow += static_cast<unsigned>(std::popcount(matters));
    seen = seeing(plan, index, point, matters, cells, s.direction, reach, cache, dimming);
    dimming = plan.absorbs ? seen : dimming & seen;
    if (plan.dims && dimming != 0) {
      each_lane(dimming, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        value.set(
            i, value.lane(i) * dimmed(plan, point.lane(i), s.direction.lane(i), reach[at], counts));
      });
    }
  }
  return select(mask_of(seen), value, Wide3(Wide(0.0)));
}

}  // namespace rt
