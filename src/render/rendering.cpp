#include "rt/render/rendering.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parallel.h"
#include "rt/render/pixel.h"

namespace rt {
namespace {

using Clock = Deadline::Clock;

// Tiles take the pilots just beyond their edges again: 6% of all pilots at this size.
constexpr int adaptive_edge = 64;
constexpr int plain_edge = 32;

/// With a time limit the picture is refined as a whole, to errors that fall by this factor from
/// pass to pass.
constexpr double pass_factor = 0.5;
/// The first of these errors: half of all there is to show.
constexpr double first_target = 0.5;
/// What a tile's pilots count of its work, with a time limit.
constexpr double pilots_share = 0.5;

/// Processor time of this thread, in seconds.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

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

int samples_of(const RenderOptions& options) {
  const int fixed = fixed_samples(options);
  return fixed == 0 && options.aa == AntiAliasing::corners ? -1 : fixed;
}

/// The earlier of the time limit's end and the pause.
std::optional<Clock::time_point> earlier(std::optional<Clock::time_point> a,
                                         std::optional<Clock::time_point> b) {
  return a && b ? std::min(*a, *b) : a ? a : b;
}

bool should_leave_off(const Until& until) { return Deadline(until.pause, until.stop).passed(); }

}  // namespace

/// One a thread, for all its tiles.
struct Rendering::Samplers {
  tbb::enumerable_thread_specific<PixelSampler> of_thread;
};

Rendering::Rendering(const RenderPlan& plan, const Crop& crop)
    : plan_(plan),
      crop_(crop),
      pixels_(static_cast<double>(crop.width) * crop.height),
      fixed_(samples_of(plan.options)),
      areas_(tiles_of(crop, adaptive() ? adaptive_edge : plain_edge)),
      finished_(areas_.size()),
      result_{Film(crop.width, crop.height), {}, {}, {}, {}, {}},
      results_(result_, crop),
      samplers_(new Samplers{
          tbb::enumerable_thread_specific<PixelSampler>([&plan] { return PixelSampler(plan); })}) {
  if (adaptive()) {
    for (const Crop& area : areas_) {
      open_.emplace_back(area);
    }
    result_.errors.resize(static_cast<std::size_t>(pixels_));
    result_.samples.resize(result_.errors.size());
    result_.pilots.resize(result_.errors.size());
  }
}

Rendering::~Rendering() = default;

double Rendering::share(std::size_t tile) const {
  return areas_[tile].width * areas_[tile].height / pixels_;
}

/// Reckons `done_` anew.
void Rendering::count_done() {
  done_ = 0.0;
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    const bool begun = adaptive() && plan_.options.time_limit > 0.0 && open_[i].begun();
    done_ += finished_[i] != 0 ? share(i) : begun ? pilots_share * share(i) : 0.0;
  }
}

/// Calls work(tile, sampler, statistics) for tiles that are not finished; it returns how much of
/// the tile's work that was. What it did to the statistics always counts.
template <class Work>
void Rendering::for_open_tiles(const Until& until, const Work& work) {
  // A thread's time is read at the end of each tile: half a microsecond, as long as ten samples.
  tbb::enumerable_thread_specific<double> counted(thread_seconds);
  for_each_index(areas_.size(), [&](std::size_t i) {
    if (finished_[i] != 0 || should_leave_off(until)) {
      return;
    }
    RenderStatistics statistics;
    double& before = counted.local();
    const double done = work(i, samplers_->of_thread.local(), statistics);
    const double now = thread_seconds();
    statistics.cpu_seconds = now - before;
    before = now;
    const std::scoped_lock lock(mutex_);
    done_ += done * share(i);
    result_.statistics += statistics;
    if (*progress_) {
      (*progress_)({std::min(done_, 1.0), result_.statistics.rays.total()});
    }
  });
}

bool Rendering::run(const ProgressFunction& progress, const Until& until) {
  const auto begin = Clock::now();
  progress_ = &progress;
  std::optional<Clock::time_point> end;
  if (adaptive() && plan_.options.time_limit > 0.0) {
    const std::chrono::duration<double> left(std::max(plan_.options.time_limit - spent_, 0.0));
    end = begin + std::chrono::duration_cast<Clock::duration>(left);
  }
  const Deadline deadline(earlier(end, until.pause), until.stop);
  if (!adaptive()) {
    plain(until);
  } else if (end) {
    progressive(deadline, until);
    out_of_time_ = Clock::now() >= *end;
  } else {
    tile_by_tile(deadline, until);
  }
  spent_ += std::chrono::duration<double>(Clock::now() - begin).count();
  progress_ = nullptr;
  const auto begun = [&](std::size_t i) { return finished_[i] != 0 || open_[i].begun(); };
  bool all = true;  // tiles that the time limit allows
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    all = all && (out_of_time_ ? begun(i) : finished_[i] != 0);
  }
  return all;
}

void Rendering::plain(const Until& until) {
  for_open_tiles(until, [&](std::size_t i, PixelSampler& sampler, RenderStatistics& statistics) {
    finished_[i] = plain_tile(areas_[i], sampler, statistics, until) ? 1 : 0;
    if (finished_[i] == 0) {
      statistics = {};  // it will be traced again
    }
    return finished_[i] != 0 ? 1.0 : 0.0;
  });
}

/// A fixed number of samples, or the classic scheme. False when it was stopped within.
bool Rendering::plain_tile(const Crop& tile, PixelSampler& sampler, RenderStatistics& statistics,
                           const Until& until) {
  const Deadline stop({}, until.stop);
  if (fixed_ == 1) {
    sampler.take_centres(tile, crop_, result_.film, statistics);
    return true;
  }
  std::optional<CornerTile> corners;
  if (fixed_ < 0) {
    corners.emplace(sampler, tile, statistics);
  }
  std::vector<Rgb> row(static_cast<std::size_t>(tile.width));
  for (int y = tile.y; y < tile.y + tile.height; ++y) {
    if (stop.told() ||
        (!corners && !uniform_row(sampler, tile.x, y, fixed_, row, stop, statistics))) {
      return false;
    }
    for (int x = tile.x; x < tile.x + tile.width; ++x) {
      const Rgb value = corners ? corners->value(x, y) : row[static_cast<std::size_t>(x - tile.x)];
      result_.film.set(x - crop_.x, y - crop_.y, value);
    }
  }
  return true;
}

void Rendering::tile_by_tile(const Deadline& deadline, const Until& until) {
  for_open_tiles(until, [&](std::size_t i, PixelSampler& sampler, RenderStatistics& statistics) {
    AdaptiveTile& tile = open_[i];
    if (!tile.begun()) {
      tile.pilots(sampler, results_, deadline, statistics);
    }
    if (!tile.begun() || !tile.refine(sampler, plan_.options.max_error, deadline, statistics)) {
      return 0.0;
    }
    tile.give(results_);
    tile.release();
    finished_[i] = 1;
    return 1.0;
  });
}

/// The same samples in the same order, but error by error over the whole picture.
void Rendering::progressive(const Deadline& deadline, const Until& until) {
  for_open_tiles(until, [&](std::size_t i, PixelSampler& sampler, RenderStatistics& statistics) {
    if (open_[i].begun()) {
      return 0.0;
    }
    open_[i].pilots(sampler, results_, deadline, statistics);
    return open_[i].begun() ? pilots_share : 0.0;
  });
  const double end = plan_.options.max_error;
  double target = std::max(first_target, end);
  for (bool last = false; !last && !deadline.passed(); target *= pass_factor) {
    last = target <= end;
    for_open_tiles({}, [&](std::size_t i, PixelSampler& sampler, RenderStatistics& statistics) {
      AdaptiveTile& tile = open_[i];
      if (!tile.refine(sampler, std::max(target, end), deadline, statistics) || !last) {
        return 0.0;
      }
      tile.give(results_);
      tile.release();
      finished_[i] = 1;
      return 1.0 - pilots_share;
    });
  }
}

ReachedError Rendering::reached() const {
  std::vector<float> errors = result_.errors;
  ReachedError r;
  r.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / pixels_;
  const auto rank = static_cast<std::ptrdiff_t>(0.99 * (pixels_ - 1.0));
  std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
  r.percentile_99 = double{errors[static_cast<std::size_t>(rank)]};
  r.unreached = static_cast<std::uint64_t>(std::count_if(
      errors.begin(), errors.end(), [&](float e) { return double{e} > plan_.options.max_error; }));
  r.out_of_time = out_of_time_ && r.unreached > 0;
  return r;
}

RenderResult Rendering::take() {
  if (adaptive()) {
    for (const AdaptiveTile& tile : open_) {
      tile.give(results_);
    }
    result_.reached = reached();
  }
  return std::move(result_);
}

std::size_t Rendering::state_bytes() const {
  std::size_t bytes = sizeof fixed_ + sizeof(std::uint64_t) + sizeof spent_ +
                      sizeof result_.statistics + finished_.size() + open_.size() +
                      sizeof(float) * (result_.film.pixels.size() + result_.errors.size()) +
                      sizeof(std::uint32_t) * (result_.samples.size() + result_.pilots.size());
  for (const AdaptiveTile& tile : open_) {
    bytes += tile.begun() ? tile.state_bytes() : 0;
  }
  return bytes;
}

void Rendering::save(ByteWriter& out) const {
  out.reserve(out.bytes().size() + state_bytes() + sizeof(std::uint64_t));  // a digest may follow
  out.value(fixed_);
  out.value(std::uint64_t{areas_.size()});
  out.value(spent_);
  out.value(result_.statistics);
  out.list(std::span<const std::uint8_t>(finished_));
  out.list(std::span<const float>(result_.film.pixels));
  out.list(std::span<const float>(result_.errors));
  out.list(std::span<const std::uint32_t>(result_.samples));
  out.list(std::span<const std::uint32_t>(result_.pilots));
  for (const AdaptiveTile& tile : open_) {
    out.value(std::uint8_t{tile.begun()});
    if (tile.begun()) {
      tile.save(out);
    }
  }
}

void Rendering::load(ByteReader& in) {
  if (in.value<int>() != fixed_ || in.value<std::uint64_t>() != areas_.size()) {
    throw std::out_of_range("another rendering's");
  }
  spent_ = in.value<double>();
  result_.statistics = in.value<RenderStatistics>();
  in.list(std::span(finished_));
  in.list(std::span(result_.film.pixels));
  in.list(std::span(result_.errors));
  in.list(std::span(result_.samples));
  in.list(std::span(result_.pilots));
  for (AdaptiveTile& tile : open_) {
    if (in.value<std::uint8_t>() != 0) {
      tile.load(in, static_cast<std::uint32_t>(plan_.options.max_samples));
    }
  }
  count_done();
}

}  // namespace rt
