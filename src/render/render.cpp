#include "rt/render/render.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numeric>
#include <thread>

#include "rt/render/adaptive.h"
#include "rt/render/pixel.h"

namespace rt {
namespace {

// Tiles take the pilots just beyond their edges again: 6% of all pilots at this size.
constexpr int adaptive_edge = 64;
constexpr int plain_edge = 16;

/// With a time limit the picture is refined as a whole, to errors that fall by this factor from
/// pass to pass.
constexpr double pass_factor = 0.5;
/// The first of these errors: half of all there is to show.
constexpr double first_target = 0.5;

/// Processor time of this thread, in seconds.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Shared by the tiles; touched once a tile.
class Shared {
 public:
  Shared(const RenderPlan& plan, const ProgressFunction& progress)
      : progress_(progress), samplers_([&plan] { return PixelSampler(plan); }) {}

  /// Does a tile's work, work(sampler, statistics): so much of all there is.
  template <class Work>
  void tile(double fraction, const Work& work) {
    RenderStatistics statistics_of_tile;
    const double begin = thread_seconds();
    work(samplers_.local(), statistics_of_tile);
    statistics_of_tile.cpu_seconds = thread_seconds() - begin;
    add(statistics_of_tile, fraction);
  }

  RenderStatistics statistics;

 private:
  void add(const RenderStatistics& tile, double fraction) {
    const std::scoped_lock lock(mutex_);
    done_ += fraction;
    statistics += tile;
    if (progress_) {
      progress_({std::min(done_, 1.0), statistics.rays.total()});
    }
  }

  std::mutex mutex_;
  double done_ = 0.0;
  const ProgressFunction& progress_;
  tbb::enumerable_thread_specific<PixelSampler> samplers_;
};

std::vector<Crop> tiles_of(const Crop& crop, int edge) {
  std::vector<Crop> tiles;
  for (int y = crop.y; y < crop.y + crop.height; y += edge) {
    for (int x = crop.x; x < crop.x + crop.width; x += edge) {
      tiles.push_back({x, y, std::min(edge, crop.x + crop.width - x),
                       std::min(edge, crop.y + crop.height - y)});
    }
  }
  return tiles;
}

#if defined(__SANITIZE_THREAD__)
// ThreadSanitizer cannot see what oneTBB synchronises. Threads that it understands take indices
// from a counter, so that it finds the races of our own code and no others.
template <class Work>
void for_each_index(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> threads;
  for (int i = 0; i < tbb::this_task_arena::max_concurrency(); ++i) {
    threads.emplace_back([&] {
      for (std::size_t index = next++; index < count; index = next++) {
        work(index);
      }
    });
  }
}
#else
template <class Work>
void for_each_index(std::size_t count, const Work& work) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          work(i);
        }
      },
      tbb::simple_partitioner());
}
#endif

class Rendering {
 public:
  Rendering(const RenderPlan& plan, const Crop& crop, const ProgressFunction& progress)
      : plan_(plan),
        crop_(crop),
        shared_(plan, progress),
        pixels_(static_cast<double>(crop.width) * crop.height),
        result_{Film(crop.width, crop.height), {}, {}, {}, {}, {}} {}

  RenderResult take() {
    const int fixed = fixed_samples(plan_.options);
    if (fixed > 0 || plan_.options.aa == AntiAliasing::corners) {
      plain(fixed);
    } else {
      result_.errors.resize(static_cast<std::size_t>(pixels_));
      result_.samples.resize(result_.errors.size());
      result_.pilots.resize(result_.errors.size());
      plan_.options.time_limit > 0.0 ? progressive() : tile_by_tile();
      result_.reached = reached();
    }
    result_.statistics = shared_.statistics;
    return std::move(result_);
  }

 private:
  double share(const Crop& tile) const { return tile.width * tile.height / pixels_; }

  /// A fixed number of samples, or (0) the classic scheme.
  void plain(int samples) {
    const std::vector<Crop> tiles = tiles_of(crop_, plain_edge);
    for_each_index(tiles.size(), [&](std::size_t i) {
      const Crop& tile = tiles[i];
      shared_.tile(share(tile), [&](PixelSampler& sampler, RenderStatistics& statistics) {
        std::optional<CornerTile> corners;
        if (samples == 0) {
          corners.emplace(sampler, tile, statistics);
        }
        for (int y = tile.y; y < tile.y + tile.height; ++y) {
          for (int x = tile.x; x < tile.x + tile.width; ++x) {
            result_.film.set(
                x - crop_.x, y - crop_.y,
                corners ? corners->value(x, y) : uniform_pixel(sampler, x, y, samples, statistics));
          }
        }
      });
    });
  }

  void tile_by_tile() {
    const std::vector<Crop> areas = tiles_of(crop_, adaptive_edge);
    for_each_index(areas.size(), [&](std::size_t i) {
      const auto work = [&](PixelSampler& sampler, RenderStatistics& statistics) {
        AdaptiveTile tile(areas[i]);
        tile.pilots(sampler, statistics);
        tile.refine(sampler, plan_.options.max_error, {}, statistics);
        keep(tile);
      };
      shared_.tile(share(areas[i]), work);
    });
  }

  /// The same samples in the same order, but error by error over the whole picture.
  void progressive() {
    const Deadline deadline(plan_.options.time_limit);
    std::vector<AdaptiveTile> tiles;
    for (const Crop& area : tiles_of(crop_, adaptive_edge)) {
      tiles.emplace_back(area);
    }
    for_each_index(tiles.size(), [&](std::size_t i) {
      shared_.tile(0.5 * share(tiles[i].area()),
                   [&](PixelSampler& sampler, RenderStatistics& statistics) {
                     tiles[i].pilots(sampler, statistics);
                   });
    });
    const double end = plan_.options.max_error;
    double target = std::max(first_target, end);
    for (bool last = false; !last && !deadline.passed(); target *= pass_factor) {
      last = target <= end;
      for_each_index(tiles.size(), [&](std::size_t i) {
        shared_.tile(last ? 0.5 * share(tiles[i].area()) : 0.0,
                     [&](PixelSampler& sampler, RenderStatistics& statistics) {
                       tiles[i].refine(sampler, std::max(target, end), deadline, statistics);
                     });
      });
    }
    for (const AdaptiveTile& tile : tiles) {
      keep(tile);
    }
    out_of_time_ = deadline.passed();
  }

  void keep(const AdaptiveTile& tile) {
    const Crop& area = tile.area();
    for (int y = area.y; y < area.y + area.height; ++y) {
      for (int x = area.x; x < area.x + area.width; ++x) {
        const PixelEstimate& e = tile.at(x, y);
        result_.film.set(x - crop_.x, y - crop_.y, e.mean());
        const std::size_t i =
            static_cast<std::size_t>(y - crop_.y) * static_cast<std::size_t>(crop_.width) +
            static_cast<std::size_t>(x - crop_.x);
        result_.errors[i] = e.error;
        result_.samples[i] = e.count;
        result_.pilots[i] = e.pilots;
      }
    }
  }

  ReachedError reached() const {
    std::vector<float> errors = result_.errors;
    ReachedError r;
    r.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / pixels_;
    const auto rank = static_cast<std::ptrdiff_t>(0.99 * (pixels_ - 1.0));
    std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
    r.percentile_99 = double{errors[static_cast<std::size_t>(rank)]};
    r.unreached =
        static_cast<std::uint64_t>(std::count_if(errors.begin(), errors.end(), [&](float e) {
          return double{e} > plan_.options.max_error;
        }));
    r.out_of_time = out_of_time_ && r.unreached > 0;
    return r;
  }

  const RenderPlan& plan_;
  Crop crop_;
  Shared shared_;
  double pixels_;
  RenderResult result_;
  bool out_of_time_ = false;
};

}  // namespace

RenderResult render(const RenderPlan& plan, const Crop& crop, const ProgressFunction& progress) {
  return Rendering(plan, crop, progress).take();
}

}  // namespace rt
