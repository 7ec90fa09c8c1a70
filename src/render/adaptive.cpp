#include "rt/render/adaptive.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "contrast.h"
#include "rt/render/thin.h"

namespace rt {
namespace {

void append_samples(std::vector<PixelSample>& wanted, int x, int y, std::uint32_t from,
                    std::uint32_t to) {
  for (std::uint32_t i = from; i < to; ++i) {
    wanted.push_back({x, y, i});
  }
}

/// Takes samples up to `count`.
void grow(PixelSampler& sampler, PixelEstimate& e, int x, int y, std::uint32_t count,
          RenderStatistics& statistics) {
  std::vector<PixelSample> wanted;
  append_samples(wanted, x, y, e.count, count);
  std::vector<std::optional<Rgb>> values(wanted.size());
  sampler.take_all(wanted, values, statistics);
  count_in(e, values, count);
}

using Floats = stdx::rebind_simd_t<float, Wide>;

std::uint32_t first_samples(const RenderOptions& options) {
  return std::min(pilot_samples, static_cast<std::uint32_t>(options.max_samples));
}

/// Whether a pixel is to take more, and may.
bool wants_more(const PixelEstimate& e, double target, const RenderOptions& options) {
  return e.error > target && 2 * e.count <= static_cast<std::uint32_t>(options.max_samples);
}

/// Takes as many pilots as something thin asks for.
void take_thin(PixelSampler& sampler, PixelEstimate& e, int x, int y, int wanted,
               const Rgb& contrast, RenderStatistics& statistics) {
  const RenderOptions& options = sampler.plan().options;
  const auto most = static_cast<std::uint32_t>(options.max_samples);
  const std::uint32_t first = e.count;
  while (static_cast<int>(e.count) < wanted && 2 * e.count <= most) {
    grow(sampler, e, x, y, 2 * e.count, statistics);
  }
  if (e.count > first) {
    estimate_thin(e, contrast, options.encoding);
  }
}

}  // namespace

/// Rows from `top` to before `bottom`, at most two: in the order of blocks two pixels wide and as
/// high, for neighbours go the same way.
void AdaptiveTile::take_rows(PixelSampler& sampler, int top, int bottom, std::span<PilotRow> rows,
                             RenderStatistics& statistics) const {
  const std::uint32_t first = first_samples(sampler.plan().options);
  const int left = area_.x - 1;
  const int right = area_.x + area_.width + 1;
  std::vector<PixelSample> wanted;
  const auto append_block = [&](int x0, int x1) {
    for (int y = top; y < bottom; ++y) {
      for (int x = x0; x < x1; ++x) {
        append_samples(wanted, x, y, 0, first);
      }
    }
  };
  const int begin = left + (left & 1);
  for (int x = begin; x < right; x += 2) {
    append_block(x, std::min(x + 2, right));
  }
  append_block(left, begin);
  std::vector<std::optional<Rgb>> values(wanted.size());
  std::vector<std::uint8_t> quadrants(wanted.size());
  sampler.take_all(wanted, values, statistics, quadrants);
  for (int y = top; y < bottom; ++y) {
    rows[static_cast<std::size_t>(y & 3)].clear();
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (values[i]) {
      rows[static_cast<std::size_t>(wanted[i].y & 3)].add(
          static_cast<std::size_t>(wanted[i].x - left), quadrants[i], *values[i]);
    }
  }
}

void AdaptiveTile::pilots(PixelSampler& sampler, PixelResults& results, const Deadline& deadline,
                          RenderStatistics& statistics) {
  const auto pixels = static_cast<std::size_t>(area_.width) + 2;
  std::vector<PilotRow> rows(4, PilotRow(pixels));  // each at its number's last two bits
  RowContrast contrast(pixels);
  RenderStatistics counted;
  const int end = area_.y + area_.height;
  int estimated = area_.y;
  for (int y = area_.y - 1; y <= end;) {
    if (deadline.told()) {
      release();
      results.clear(area_);
      return;
    }
    const int next = std::min((y | 1) + 1, end + 1);
    RenderStatistics of_rows;
    take_rows(sampler, y, next, rows, of_rows);
    of_rows.bad_samples = 0;  // estimate_row() counts those of the tile itself
    counted += of_rows;
    for (; estimated + 1 < next; ++estimated) {
      estimate_row(sampler, estimated, rows, contrast, results, counted);
    }
    y = next;
  }
  begun_ = true;
  statistics += counted;
}

/// A row's pixels, from the pilots of it and of the rows beside.
void AdaptiveTile::estimate_row(PixelSampler& sampler, int y, std::span<const PilotRow> rows,
                                RowContrast& contrast, PixelResults& results,
                                RenderStatistics& statistics) {
  const RenderPlan& plan = sampler.plan();
  const std::uint32_t first = first_samples(plan.options);
  const auto row = [&](int at) { return &rows[static_cast<std::size_t>(at & 3)]; };
  contrast.add_up({row(y - 1), row(y), row(y + 1)});
  for (int x = 0; x < area_.width; x += lanes) {
    const auto k = static_cast<std::size_t>(x) + 1;  // there is a neighbour before the first
    const int count = std::min(lanes, area_.width - x);
    const OwnPilots own(*row(y), k);
    const Wide3 of_one = contrast.variance(k);
    // As it is kept: rounded to floats.
    const auto error = stdx::static_simd_cast<Wide>(stdx::static_simd_cast<Floats>(
        estimated_error(own.mean, of_one, first, plan.options.encoding)));
    results.set_row(area_.x + x, y, count, own.mean, error, first);
    const unsigned more = bits_of(error > plan.options.max_error) |
                          bits_of(own.number < 1.0 * first) | (plan.thin ? all_lanes : 0U);
    each_lane(more & ((1U << count) - 1U), [&](int i) {
      const std::size_t pixel = k + static_cast<std::size_t>(i);
      std::array<std::optional<Rgb>, pilot_samples> values;  // what is left empty was bad
      std::size_t n = 0;
      row(y)->each_of(pixel, [&](const Rgb& value) { values[n++] = value; });
      begin_pixel(sampler, area_.x + x + i, y, std::span(values).first(first), of_one.lane(i),
                  static_cast<float>(error[static_cast<std::size_t>(i)]), results, statistics);
    });
  }
}

/// A pixel that may want more than its first samples, `values`, or has bad ones among them.
void AdaptiveTile::begin_pixel(PixelSampler& sampler, int x, int y,
                               std::span<const std::optional<Rgb>> values, const Rgb& contrast,
                               float error, PixelResults& results, RenderStatistics& statistics) {
  const RenderPlan& plan = sampler.plan();
  Open pixel{{}, x, y};
  PixelEstimate& e = pixel.estimate;
  count_in(e, values, static_cast<std::uint32_t>(values.size()));
  for (std::uint32_t i = 0; i < e.bad; ++i) {
    statistics.add_bad(x, y);
  }
  e.variance = variance_of_pilots(contrast, e.count);
  e.error = error;
  if (plan.thin) {
    take_thin(sampler, e, x, y, thin_pilots(plan, x, y), contrast, statistics);
  }
  e.pilots = e.count;
  results.set(x, y, e);
  if (wants_more(e, plan.options.max_error, plan.options)) {
    open_.push_back(pixel);
  }
}

void AdaptiveTile::double_samples(PixelSampler& sampler, std::span<Open* const> pixels,
                                  Buffers& buffers, RenderStatistics& statistics) {
  auto& [wanted, values] = buffers;
  wanted.clear();
  for (const Open* pixel : pixels) {
    append_samples(wanted, pixel->x, pixel->y, pixel->estimate.count, 2 * pixel->estimate.count);
  }
  values.resize(wanted.size());
  sampler.take_all(wanted, values, statistics);
  std::span<const std::optional<Rgb>> rest = values;
  for (Open* pixel : pixels) {
    PixelEstimate& e = pixel->estimate;
    const std::uint32_t more = e.count;
    count_in(e, rest.first(more), 2 * more);
    rest = rest.subspan(more);
    estimate_doubled(e, sampler.plan().options.encoding);
  }
}

// In rounds over two rows, so that neighbours fill packets together.
bool AdaptiveTile::refine(PixelSampler& sampler, double target, const Deadline& deadline,
                          RenderStatistics& statistics) {
  constexpr std::uint32_t batch = 256;
  const RenderOptions& options = sampler.plan().options;
  Buffers buffers;
  std::vector<Open*> round;
  for (auto next = open_.begin(); next != open_.end();) {
    round.clear();
    const int rows = next->y >> 1;
    std::size_t upper = 0;
    for (; next != open_.end() && next->y >> 1 == rows; ++next) {
      if (wants_more(next->estimate, target, options)) {
        upper += next->y & 1 ? 0 : 1;
        round.push_back(&*next);
      }
    }
    std::ranges::inplace_merge(round, round.begin() + static_cast<std::ptrdiff_t>(upper), {},
                               [](const Open* pixel) { return pixel->x >> 1; });
    while (!round.empty()) {
      for (std::span<Open* const> rest = round; !rest.empty();) {
        std::size_t n = 0;
        for (std::uint32_t samples = 0; n < rest.size() && samples < batch; ++n) {
          samples += rest[n]->estimate.count;
        }
        if (deadline.passed()) {
          return false;
        }
        double_samples(sampler, rest.first(n), buffers, statistics);
        rest = rest.subspan(n);
      }
      std::erase_if(round, [&](const Open* pixel) {
        return !wants_more(pixel->estimate, target, options);
      });
    }
  }
  return true;
}

void AdaptiveTile::give(PixelResults& results) const {
  for (const auto& [e, x, y] : open_) {
    results.set(x, y, e);
  }
}

void AdaptiveTile::release() {
  begun_ = false;
  std::vector<Open>().swap(open_);
}

std::size_t AdaptiveTile::state_bytes() const {
  return sizeof(std::uint64_t) + sizeof(Open) * open_.size();
}

void AdaptiveTile::save(ByteWriter& out) const {
  out.value(std::uint64_t{open_.size()});
  out.list(std::span(open_));
}

void AdaptiveTile::load(ByteReader& in, std::uint32_t most) {
  const auto count = in.value<std::uint64_t>();
  if (count > static_cast<std::uint64_t>(area_.width) * static_cast<std::uint64_t>(area_.height)) {
    throw std::out_of_range("too many pixels");
  }
  open_.assign(count, {});
  in.list(std::span(open_));
  const std::uint32_t first = std::min(pilot_samples, most);
  for (const auto& [e, x, y] : open_) {
    const std::uint32_t doublings = e.count / first;
    const bool regular = std::has_single_bit(doublings) && doublings * first == e.count;
    const bool within = x >= area_.x && x < area_.x + area_.width && y >= area_.y &&
                        y < area_.y + area_.height;
    if (!regular || !within || e.count > most || e.pilots > e.count || e.bad > e.count) {
      throw std::out_of_range("no pixel");
    }
  }
  begun_ = true;
}

}  // namespace rt
