#include "rt/render/packet/packet_sample.h"

#include <algorithm>
#include <array>

#include "rt/math/wide_functions.h"

namespace rt {
namespace {

/// Whether the cache answers for all these places alike.
bool one_block(const Wide2& places) {
  const Wide i = stdx::floor(places.x / (1.0 * SightCache::block));
  const Wide j = stdx::floor(places.y / (1.0 * SightCache::block));
  return stdx::all_of(i == Wide(i[0]) && j == Wide(j[0]));
}

/// The colours of a block of pixels in rows of `across` lanes.
void put(const Wide3& colours, int across, const Crop& block, Film& film) {
  using Floats = stdx::rebind_simd_t<float, Wide>;
  std::array<std::array<float, lanes>, 3> values;
  const auto keep = [](const Wide& v, std::array<float, lanes>& to) {
    stdx::static_simd_cast<Floats>(v).copy_to(to.data(), stdx::element_aligned);
  };
  keep(colours.x, values[0]);
  keep(colours.y, values[1]);
  keep(colours.z, values[2]);
  for (int j = 0; j < block.height; ++j) {
    float* p = film.at(block.x, block.y + j);
    for (int i = 0; i < block.width; ++i, p += 3) {
      const auto lane = static_cast<std::size_t>(j * across + i);
      p[0] = values[0][lane];
      p[1] = values[1][lane];
      p[2] = values[2][lane];
    }
  }
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
  for (std::size_t i = 0; i < wanted.size(); i += lanes) {
    const std::size_t n = std::min<std::size_t>(lanes, wanted.size() - i);
    take_packet(wanted.subspan(i, n), values.subspan(i, n), statistics,
                quadrants.empty() ? quadrants : quadrants.subspan(i, n), sight);
  }
}

void PacketSampler::take_centres(const Crop& tile, const Crop& crop, Film& film,
                                 RenderStatistics& statistics, SightCache& sight) {
  constexpr int edge = SightCache::block;
  const int right = tile.x + tile.width;
  const int bottom = tile.y + tile.height;
  for (int y = tile.y, next_y = 0; y < bottom; y = next_y) {
    next_y = std::min(y / edge * edge + edge, bottom);
    for (int x = tile.x, next_x = 0; x < right; x = next_x) {
      next_x = std::min(x / edge * edge + edge, right);
      const Candidates candidates = sight.through(x + 0.5, y + 0.5);
      take_block({x, y, next_x - x, next_y - y}, candidates, crop, film, statistics);
    }
  }
}

/// Pixels that the cache answers for alike, as many at a time as there are lanes: neighbours go the
/// same way.
void PacketSampler::take_block(const Crop& block, const Candidates& candidates, const Crop& crop,
                               Film& film, RenderStatistics& statistics) {
  constexpr int high = std::min(lanes, 2);
  constexpr int across = lanes / high;
  const Wide2 centres{Wide([](auto i) { return 0.5 + static_cast<int>(i) % across; }),
                      Wide([](auto i) { return 0.5 + static_cast<int>(i) / across; })};
  const int right = block.x + block.width;
  const int bottom = block.y + block.height;
  for (int y = block.y; y < bottom; y += high) {
    for (int x = block.x; x < right; x += across) {
      const Crop part{x, y, std::min(across, right - x), std::min(high, bottom - y)};
      const unsigned row = (1U << part.width) - 1U;
      const unsigned active = part.height == 2 ? row | row << across : row;
      WideSampler sampler;
      if (plan_.random || own_rays()) {
        for (int i = 0; i < lanes; ++i) {
          sampler.set(i, x + i % across, y + i / across, 0);
        }
        sampler.begin(plan_.options.seed);
      }
      const Wide2 places{x + centres.x, y + centres.y};
      Wide3 sum = traced(places, active, sampler, candidates, statistics);
      if (const unsigned bad = active & ~bits_of(all_finite(sum))) {
        sum = select(all_finite(sum), sum, Wide3(Wide(0.0)));
        each_lane(bad, [&](int i) { statistics.add_bad(x + i % across, y + i / across); });
      }
      put(sum, across, {x - crop.x, y - crop.y, part.width, part.height}, film);
    }
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

/// What arrives at those places of the picture, in pixels from its top left.
Wide3 PacketSampler::traced(const Wide2& places, unsigned active, const WideSampler& sampler,
                            const Candidates& candidates, RenderStatistics& statistics) {
  const Wide px = places.x / plan_.options.width;
  const Wide py = places.y / plan_.options.height;
  WideRay camera{Wide3(Wide(0.0)), direction(plan_.camera, px, py)};
  Wide times(0.0);
  for (int i = 0; i < lanes && own_rays(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const TraceRay ray = camera_ray(plan_, px[at], py[at], sampler.lane(i));
    camera.origin.set(i, ray.origin);
    camera.direction.set(i, ray.direction);
    times[at] = ray.time;
  }
  statistics.samples += static_cast<unsigned>(std::popcount(active));
  const Wide y = min(max(py, Wide(0.0)), Wide(1.0));
  return tracer_.radiance(camera, active, plan_.moves ? &times : nullptr, y, sampler,
                          statistics.rays, candidates);
}

void PacketSampler::take_packet(std::span<const PixelSample> wanted,
                                std::span<std::optional<Rgb>> values, RenderStatistics& statistics,
                                std::span<std::uint8_t> quadrants, SightCache& sight) {
  const auto count = static_cast<unsigned>(wanted.size());
  const auto lane_of = [&](auto i) -> const PixelSample& {
    return wanted[std::min<std::size_t>(i, count - 1)];
  };
  WideSampler sampler;
  for (std::size_t i = 0; i < lanes; ++i) {
    const PixelSample& s = lane_of(i);
    sampler.set(static_cast<int>(i), s.x, s.y, s.index);
  }
  sampler.begin(plan_.options.seed);
  const Wide2 u = sampler.pixel();
  const Wide2 by = filter_offset(plan_.options.filter, u);
  const unsigned right = bits_of(u.x >= 0.5);
  const unsigned bottom = bits_of(u.y >= 0.5);
  for (std::size_t i = 0; i < quadrants.size(); ++i) {
    quadrants[i] = static_cast<std::uint8_t>((right >> i & 1U) + 2 * (bottom >> i & 1U));
  }
  const Wide2 corner{Wide([&](auto i) { return static_cast<double>(lane_of(i).x); }),
                     Wide([&](auto i) { return static_cast<double>(lane_of(i).y); })};
  const Wide2 places{corner.x + (0.5 + by.x), corner.y + (0.5 + by.y)};
  const unsigned active = (1U << count) - 1U;
  const Wide3 sum =
      traced(places, active, sampler, sight_of(sight, places, count), statistics);
  for (unsigned i = 0; i < count; ++i) {
    values[i] = sum.lane(static_cast<int>(i));
  }
  each_lane(active & ~bits_of(all_finite(sum)), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    statistics.add_bad(wanted[at].x, wanted[at].y);
    values[at] = std::nullopt;
  });
}

}  // namespace rt
