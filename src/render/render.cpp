#include "rt/render/render.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <time.h>

#include <algorithm>
#include <mutex>
#include <tuple>

#include "rt/render/pixel.h"

namespace rt {
namespace {

constexpr int tile_edge = 16;

/// Processor time of this thread, in seconds.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Shared by the tiles; touched once a tile.
class Shared {
 public:
  Shared(const Crop& crop, const ProgressFunction& progress)
      : pixels_(static_cast<double>(crop.width) * crop.height), progress_(progress) {}

  void add(const RenderStatistics& tile, int pixels) {
    const std::scoped_lock lock(mutex_);
    done_ += pixels;
    if (tile.bad_samples > 0 && (statistics.bad_samples == 0 ||
                                 std::tie(tile.first_bad_y, tile.first_bad_x) <
                                     std::tie(statistics.first_bad_y, statistics.first_bad_x))) {
      statistics.first_bad_x = tile.first_bad_x;
      statistics.first_bad_y = tile.first_bad_y;
    }
    statistics.bad_samples += tile.bad_samples;
    statistics.samples += tile.samples;
    statistics.cpu_seconds += tile.cpu_seconds;
    statistics.rays += tile.rays;
    if (progress_) {
      progress_({done_ / pixels_, statistics.rays.total()});
    }
  }

  RenderStatistics statistics;

 private:
  std::mutex mutex_;
  double done_ = 0.0;
  double pixels_;
  const ProgressFunction& progress_;
};

void render_tile(const RenderPlan& plan, const Crop& crop, const Crop& tile, Film& film,
                 Shared& shared) {
  RenderStatistics statistics;
  const double begin = thread_seconds();
  Tracer tracer(plan);
  for (int y = tile.y; y < tile.y + tile.height; ++y) {
    for (int x = tile.x; x < tile.x + tile.width; ++x) {
      film.set(x - crop.x, y - crop.y, render_pixel(tracer, x, y, statistics));
    }
  }
  statistics.cpu_seconds = thread_seconds() - begin;
  shared.add(statistics, tile.width * tile.height);
}

}  // namespace

RenderResult render(const RenderPlan& plan, const Crop& crop, const ProgressFunction& progress) {
  Film film(crop.width, crop.height);
  Shared shared(crop, progress);
  const int columns = (crop.width + tile_edge - 1) / tile_edge;
  const int rows = (crop.height + tile_edge - 1) / tile_edge;
  const auto tile = [&](int index) {
    const int x = crop.x + (index % columns) * tile_edge;
    const int y = crop.y + (index / columns) * tile_edge;
    render_tile(plan, crop,
                {x, y, std::min(tile_edge, crop.x + crop.width - x),
                 std::min(tile_edge, crop.y + crop.height - y)},
                film, shared);
  };
  tbb::parallel_for(
      tbb::blocked_range<int>(0, columns * rows, 1),
      [&](const tbb::blocked_range<int>& range) {
        for (int i = range.begin(); i != range.end(); ++i) {
          tile(i);
        }
      },
      tbb::simple_partitioner());
  return {std::move(film), shared.statistics};
}

}  // namespace rt
