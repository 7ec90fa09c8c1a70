#include "rt/render/sample.h"

#include <algorithm>
#include <cmath>

#include "rt/math/filter.h"
#include "rt/math/warp.h"
#include "rt/render/packet/packet_sample.h"

namespace rt {
namespace {

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

TraceRay camera_ray(const RenderPlan& plan, double px, double py, const Sampler& sample) {
  return plan.moves ? moving_ray(plan, px, py, sample) : lens_ray(plan.camera, px, py, sample);
}

PixelSampler::PixelSampler(const RenderPlan& plan)
    : tracer_(plan), sight_(plan), packets_(std::make_unique<PacketSampler>(plan)) {}

PixelSampler::~PixelSampler() = default;
PixelSampler::PixelSampler(PixelSampler&&) noexcept = default;

std::optional<Rgb> PixelSampler::take_at(int x, int y, const Vec2& offset, const Sampler& sample,
                                         RenderStatistics& statistics) {
  const RenderPlan& plan = tracer_.plan();
  const double px = (x + offset.x) / plan.options.width;
  const double py = (y + offset.y) / plan.options.height;
  // Filters reach beyond the picture's edge; the background's gradient does not.
  const Rgb value =
      tracer_.radiance(camera_ray(plan, px, py, sample), std::clamp(py, 0.0, 1.0), sample,
                       statistics.rays, sight_.through(x + offset.x, y + offset.y));
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
                            std::span<std::optional<Rgb>> values, RenderStatistics& statistics,
                            std::span<std::uint8_t> quadrants) {
  packets_->take(wanted, values, statistics, quadrants, sight_);
}

void PixelSampler::take_centres(const Crop& tile, const Crop& crop, Film& film,
                                RenderStatistics& statistics) {
  packets_->take_centres(tile, crop, film, statistics, sight_);
}

}  // namespace rt
