#include "rt/render/sample.h"

#include <algorithm>
#include <cmath>

#include "rt/math/filter.h"
#include "rt/math/warp.h"

namespace rt {
namespace {

template <std::size_t n>
std::array<Sampler, n> same_in_all(const Sampler& s) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::array<Sampler, n>{((void)i, s)...};
  }(std::make_index_sequence<n>());
}

/// The ray through picture coordinates. With a lens it starts anywhere on it and meets the others
/// of that place in the plane in focus.
TraceRay lens_ray(const CameraFrame& camera, double px, double py, const Sampler& sample) {
  const Vec3 direction = camera.direction(px, py);
  if (camera.lens_radius == 0.0) {
    return {Vec3(0.0), direction};
  }
  const Vec2 lens = camera.lens_radius * to_disc(sample.lens());
  const Vec3 origin = lens.x * glm::normalize(camera.right) + lens.y * glm::normalize(camera.down);
  return {origin, direction - origin / camera.focus};
}

/// The ray of a scene where something moves: at a time of its own.
TraceRay moving_ray(const RenderPlan& plan, double px, double py, const Sampler& sample) {
  const double time = sample.time();
  TraceRay ray;
  if (plan.moving_camera) {
    const double open = plan.options.shutter_open;
    const Camera now =
        at_time(*plan.moving_camera, std::lerp(open, plan.options.shutter_close, time));
    ray = lens_ray(frame_of(now, plan.options), px, py, sample);
    ray.origin += now.eye - at_time(*plan.moving_camera, open).eye;
  } else {
    ray = lens_ray(plan.camera, px, py, sample);
  }
  ray.time = time;
  return ray;
}

}  // namespace

PixelSampler::PixelSampler(const RenderPlan& plan) : tracer_(plan), sight_(plan) {
  if (PacketTracer::serves(plan)) {
    packets_.emplace(plan);
  }
}

std::optional<Rgb> PixelSampler::take_at(int x, int y, const Vec2& offset, const Sampler& sample,
                                         RenderStatistics& statistics) {
  const RenderPlan& plan = tracer_.plan();
  const double px = (x + offset.x) / plan.options.width;
  const double py = (y + offset.y) / plan.options.height;
  // Filters reach beyond the picture's edge; the background's gradient does not.
  const TraceRay ray =
      plan.moves ? moving_ray(plan, px, py, sample) : lens_ray(plan.camera, px, py, sample);
  const Rgb value = tracer_.radiance(ray, std::clamp(py, 0.0, 1.0), sample, statistics.rays,
                                     sight_.through(x + offset.x, y + offset.y));
  ++statistics.samples;
  if (!all_finite(value)) {
    statistics.add_bad(x, y);
    return std::nullopt;
  }
  return value;
}

std::optional<Rgb> PixelSampler::take(int x, int y, const Sampler& sample,
                                      RenderStatistics& statistics) {
  const Vec2 offset = filter_offset(tracer_.plan().options.filter, sample.pixel());
  return take_at(x, y, 0.5 + offset, sample, statistics);
}

void PixelSampler::take_all(std::span<const PixelSample> wanted,
                            std::span<std::optional<Rgb>> values, RenderStatistics& statistics) {
  if (packets_) {
    for (std::size_t i = 0; i < wanted.size(); i += lanes) {
      const std::size_t n = std::min<std::size_t>(lanes, wanted.size() - i);
      take_packet(wanted.subspan(i, n), values.subspan(i, n), statistics);
    }
    return;
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const PixelSample& s = wanted[i];
    values[i] = s.at_centre ? take_at(s.x, s.y, Vec2(0.5), s.sampler, statistics)
                            : take(s.x, s.y, s.sampler, statistics);
  }
}

/// What the camera's rays through some places can meet, if that is known to be little.
Candidates PixelSampler::sight_of(const std::array<Vec2, lanes>& places, unsigned count) {
  const Candidates first = sight_.through(places[0].x, places[0].y);
  union_.assign(first.instances.begin(), first.instances.end());
  bool known = first.known;
  for (unsigned i = 1; i < count && known; ++i) {
    const Candidates next = sight_.through(places[i].x, places[i].y);
    known = next.known;
    for (const std::uint32_t id : next.instances) {
      if (std::ranges::find(union_, id) == union_.end()) {
        union_.push_back(id);
      }
    }
  }
  return {known, false, union_};
}

void PixelSampler::take_packet(std::span<const PixelSample> wanted,
                               std::span<std::optional<Rgb>> values,
                               RenderStatistics& statistics) {
  const RenderPlan& plan = tracer_.plan();
  const auto count = static_cast<unsigned>(wanted.size());
  std::array<Vec2, lanes> places{};
  std::array<Sampler, lanes> samplers = same_in_all<lanes>(wanted[0].sampler);
  Packet camera;
  camera.active = (1U << count) - 1U;
  Wide y(0.0);
  for (std::size_t i = 0; i < lanes; ++i) {
    const PixelSample& s = wanted[std::min<std::size_t>(i, count - 1)];
    const Vec2 offset =
        s.at_centre ? Vec2(0.5) : 0.5 + filter_offset(plan.options.filter, s.sampler.pixel());
    places[i] = {s.x + offset.x, s.y + offset.y};
    samplers[i] = s.sampler;
    const double px = places[i].x / plan.options.width;
    const double py = places[i].y / plan.options.height;
    const TraceRay ray = lens_ray(plan.camera, px, py, s.sampler);
    camera.ray.origin.set(static_cast<int>(i), ray.origin);
    camera.ray.direction.set(static_cast<int>(i), ray.direction);
    y[i] = std::clamp(py, 0.0, 1.0);
  }
  const Wide3 sum =
      packets_->radiance(camera, y, samplers, statistics.rays, sight_of(places, count));
  statistics.samples += count;
  for (unsigned i = 0; i < count; ++i) {
    const Rgb value = sum.lane(static_cast<int>(i));
    values[i] = value;
    if (!all_finite(value)) {
      statistics.add_bad(wanted[i].x, wanted[i].y);
      values[i] = std::nullopt;
    }
  }
}

}  // namespace rt
