#include "rt/render/pixel.h"

#include "rt/math/sampler.h"

namespace rt {

Rgb render_pixel(Tracer& tracer, int x, int y, RenderStatistics& statistics) {
  const RenderPlan& plan = tracer.plan();
  const RenderOptions& options = plan.options;
  const int count = options.antialiasing ? options.samples : 1;
  const Sampler sampler(options.seed, x, y, 0);
  Rgb sum(0.0);
  int good = 0;
  for (int i = 0; i < count; ++i) {
    const Sampler sample = sampler.at(static_cast<std::uint32_t>(i));
    const Vec2 offset = count == 1 ? Vec2(0.5) : sample.pixel();
    const double px = (x + offset.x) / options.width;
    const double py = (y + offset.y) / options.height;
    const TraceRay ray{Vec3(0.0), plan.camera.direction(px, py)};
    const Rgb value = tracer.radiance(ray, py, sample, statistics.rays);
    if (all_finite(value)) {
      sum += value;
      ++good;
    } else if (statistics.bad_samples++ == 0) {
      statistics.first_bad_x = x;
      statistics.first_bad_y = y;
    }
  }
  statistics.samples += static_cast<std::uint64_t>(count);
  return good > 0 ? sum / static_cast<double>(good) : Rgb(0.0);
}

}  // namespace rt
