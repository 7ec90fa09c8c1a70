#include "rt/render/sample.h"

#include <algorithm>

#include "rt/math/filter.h"
#include "rt/math/warp.h"

namespace rt {
namespace {

/// The ray through picture coordinates. With a lens it starts anywhere on it and meets the others
/// of that place in the plane in focus.
TraceRay camera_ray(const CameraFrame& camera, double px, double py, const Sampler& sample) {
  const Vec3 direction = camera.direction(px, py);
  if (camera.lens_radius == 0.0) {
    return {Vec3(0.0), direction};
  }
  const Vec2 lens = camera.lens_radius * to_disc(sample.lens());
  const Vec3 origin = lens.x * glm::normalize(camera.right) + lens.y * glm::normalize(camera.down);
  return {origin, direction - origin / camera.focus};
}

}  // namespace

std::optional<Rgb> PixelSampler::take_at(int x, int y, const Vec2& offset, const Sampler& sample,
                                         RenderStatistics& statistics) {
  const RenderPlan& plan = tracer_.plan();
  const double px = (x + offset.x) / plan.options.width;
  const double py = (y + offset.y) / plan.options.height;
  // Filters reach beyond the picture's edge; the background's gradient does not.
  const Rgb value = tracer_.radiance(camera_ray(plan.camera, px, py, sample),
                                     std::clamp(py, 0.0, 1.0), sample, statistics.rays);
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

}  // namespace rt
