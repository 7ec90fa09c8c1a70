#include "rt/render/packet/packet_sample.h"

#include <algorithm>
#include <limits>

#include "rt/math/wide_functions.h"

namespace rt {
namespace {

/// Whether the cache answers for all these places alike.
bool one_block(const Wide2& places) {
  const Wide i = stdx::floor(places.x / SightCache::block);
  const Wide j = stdx::floor(places.y / SightCache::block);
  return stdx::all_of(i == Wide(i[0]) && j == Wide(j[0]));
}

/// As CameraFrame::direction().
Wide3 direction(const CameraFrame& camera, const Wide& x, const Wide& y) {
  return Wide3(camera.forward) + (2.0 * x - 1.0) * Wide3(camera.right) +
         (2.0 * y - 1.0) * Wide3(camera.down);
}

}  // namespace

void PacketSampler::take(std::span<const PixelSample> wanted, std::span<std::optional<Rgb>> values,
                         RenderStatistics& statistics, std::span<std::uint8_t> quadrants,
                         SightCache& sight) {
  for (std::size_t i = 0; i < wanted.size();) {
    const std::size_t most = std::min<std::size_t>(lanes, wanted.size() - i);
    std::size_t n = 1;
    while (n < most && wanted[i + n].at_centre == wanted[i].at_centre) {
      ++n;
    }
    take_packet(wanted.subspan(i, n), values.subspan(i, n), statistics,
                quadrants.empty() ? quadrants : quadrants.subspan(i, n), sight);
    i += n;
  }
}

/// What the camera's rays through some places can meet, if that is known to be little.
Candidates PacketSampler::sight_of(SightCache& sight, const Wide2& places, unsigned count) {
  const Candidates first = sight.through(places.x[0], places.y[0]);
  if (!first.known || one_block(places)) {
    return first;
  }
  union_.assign(first.instances.begin(), first.instances.end());
  for (std::size_t i = 1; i < count; ++i) {
    const Candidates next = sight.through(places.x[i], places.y[i]);
    if (!next.known) {
      return next;
    }
    for (const std::uint32_t id : next.instances) {
      if (std::ranges::find(union_, id) == union_.end()) {
        union_.push_back(id);
      }
    }
  }
  return {true, false, union_};
}

void PacketSampler::take_packet(std::span<const PixelSample> wanted,
                                std::span<std::optional<Rgb>> values, RenderStatistics& statistics,
                                std::span<std::uint8_t> quadrants, SightCache& sight) {
  const RenderPlan& plan = plan_;
  const auto count = static_cast<unsigned>(wanted.size());
  const bool lens = plan.camera.lens_radius > 0.0;
  const bool centres = wanted[0].at_centre;
  const bool own_rays = lens || plan.moves;
  const bool draws = plan.random || own_rays || !centres;
  const auto lane_of = [&](auto i) -> const PixelSample& {
    return wanted[std::min<std::size_t>(i, count - 1)];
  };
  const Wide2 corner{Wide([&](auto i) { return static_cast<double>(lane_of(i).x); }),
                     Wide([&](auto i) { return static_cast<double>(lane_of(i).y); })};
  WideSampler sampler;
  Wide2 offset{0.5, 0.5};
  if (draws) {
    for (std::size_t i = 0; i < lanes; ++i) {
      const PixelSample& s = lane_of(i);
      sampler.set(static_cast<int>(i), s.x, s.y, s.index);
    }
    sampler.begin(plan.options.seed);
    if (!centres) {
      const Wide2 u = sampler.pixel();
      const Wide2 by = filter_offset(plan.options.filter, u);
      offset = {0.5 + by.x, 0.5 + by.y};
      const unsigned right = bits_of(u.x >= 0.5);
      const unsigned bottom = bits_of(u.y >= 0.5);
      for (std::size_t i = 0; i < quadrants.size(); ++i) {
        quadrants[i] = static_cast<std::uint8_t>((right >> i & 1U) + 2 * (bottom >> i & 1U));
      }
    }
  }
  const Wide2 place{corner.x + offset.x, corner.y + offset.y};
  const Wide px = place.x / plan.options.width;
  const Wide py = place.y / plan.options.height;
  const unsigned active = (1U << count) - 1U;
  WideRay camera{Wide3(Wide(0.0)), direction(plan.camera, px, py)};
  Wide times(0.0);
  for (int i = 0; i < lanes && own_rays; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const TraceRay ray = camera_ray(plan, px[at], py[at], sampler.lane(i));
    camera.origin.set(i, ray.origin);
    camera.direction.set(i, ray.direction);
    times[at] = ray.time;
  }
  const Wide y = min(max(py, Wide(0.0)), Wide(1.0));
  const Wide3 sum =
      tracer_.radiance(camera, active, plan.moves ? &times : nullptr, y, sampler, statistics.rays,
                       sight_of(sight, place, count));
  statistics.samples += count;
  for (unsigned i = 0; i < count; ++i) {
    values[i] = sum.lane(static_cast<int>(i));
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const unsigned good =
      bits_of(abs(sum.x) < infinity && abs(sum.y) < infinity && abs(sum.z) < infinity);
  each_lane(active & ~good, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    statistics.add_bad(wanted[at].x, wanted[at].y);
    values[at] = std::nullopt;
  });
}

}  // namespace rt
