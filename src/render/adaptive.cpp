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

/// The claimed error is so many standard deviations: chosen such that 95% of true errors lie below
/// 1.5 times the claim (bench/results/calibration.md).
constexpr double claim = 1.3;

/// What the estimate before a doubling counts against each of the two that come with it.
constexpr double memory = 2.0;

constexpr double max_exponent = 1.5;

/// The contrast, of few samples, counts so many times.
constexpr double caution = 2.0;

/// n^-max_exponent.
double fastest(double n) { return 1.0 / (n * std::sqrt(n)); }

/// Counts the next samples in; there are to be `count` of them: from 4 on twice as many as
/// before.
void count_in(PixelEstimate& e, std::span<const std::optional<Rgb>> values, std::uint32_t count) {
  if (e.count >= 4) {
    e.quarters = {e.quarters[0] + e.quarters[1], e.quarters[2] + e.quarters[3], Rgb(0.0), Rgb(0.0)};
  }
  const std::uint32_t quarter = std::max(count / 4, 1u);
  for (std::uint32_t q = e.count / quarter; !values.empty(); ++q) {
    const auto next = values.first(std::min<std::size_t>(quarter, values.size()));
    for (const auto& value : next) {
      if (value) {
        e.quarters[q] += *value;
        e.squares += *value * *value;
      } else {
        ++e.bad;
      }
    }
    e.count += static_cast<std::uint32_t>(next.size());
    values = values.subspan(next.size());
  }
}

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

/// The variance of one sample, from those taken.
Rgb variance_of_samples(const PixelEstimate& e) {
  const Rgb mean = e.mean();
  return glm::max(e.squares / std::max(1.0 * (e.count - e.bad), 1.0) - mean * mean, Rgb(0.0));
}

/// How fast the variance of the mean has fallen, from one sample to half of those taken by now.
double observed_exponent(const PixelEstimate& e, const Rgb& sample) {
  const double of_samples = sample.r + sample.g + sample.b;
  const double of_mean = e.variance.r + e.variance.g + e.variance.b;
  if (!(of_samples > 0.0 && of_mean > 0.0)) {
    return max_exponent;
  }
  return std::clamp(std::log2(of_samples / of_mean) / std::log2(0.5 * e.count), 1.0, max_exponent);
}

void set_error(PixelEstimate& e, Encoding encoding) {
  e.error = static_cast<float>(displayed_error(e.mean(), claim * glm::sqrt(e.variance), encoding));
}

/// Takes `wanted`, as many samples of each pixel as it has, and estimates anew.
void double_samples(PixelSampler& sampler, std::span<PixelEstimate* const> pixels,
                    std::span<const PixelSample> wanted, Encoding encoding,
                    RenderStatistics& statistics) {
  std::vector<std::optional<Rgb>> values(wanted.size());
  sampler.take_all(wanted, values, statistics);
  std::span<const std::optional<Rgb>> rest = values;
  for (PixelEstimate* e : pixels) {
    const std::uint32_t more = e->count;
    count_in(*e, rest.first(more), 2 * more);
    rest = rest.subspan(more);
    const Rgb sample = variance_of_samples(*e);
    const double rate = observed_exponent(*e, sample);
    const double between = 0.5 * (rate + max_exponent);
    e->variance = (memory * std::exp2(-rate) * e->variance + variance_of_quarters(*e, rate) +
                   std::exp2(-between * std::log2(e->count)) * sample) /
                  (memory + 2.0);
    set_error(*e, encoding);
  }
}

/// Errors of a row's pixels from `pilots` samples of each and of its neighbours, and from those
/// that pixels have beyond.
void estimate(std::span<PixelEstimate> pixels, const RowContrast& contrast, const PilotRow& row,
              std::uint32_t pilots, Encoding encoding) {
  const double of_pilots = caution * fastest(pilots);
  for (std::size_t x = 0; x < pixels.size(); x += lanes) {
    const Wide3 variance = of_pilots * contrast.variance(x + 1);
    const Wide3 deviation(sqrt(variance.x), sqrt(variance.y), sqrt(variance.z));
    const Wide error = displayed_error(own_means(row, x + 1), claim * deviation, encoding);
    for (std::size_t i = 0; i < lanes && x + i < pixels.size(); ++i) {
      pixels[x + i].variance = variance.lane(static_cast<int>(i));
      pixels[x + i].error = static_cast<float>(error[i]);
    }
  }
  for (PixelEstimate& e : pixels) {
    if (e.count > pilots) {
      // So many pilots for the sake of something thin: their own scatter is evidence, too.
      e.variance = (fastest(e.count) * (e.variance / of_pilots + variance_of_samples(e)) +
                    variance_of_quarters(e, 0.5 * (1.0 + max_exponent))) /
                   3.0;
      set_error(e, encoding);
    }
  }
}

}  // namespace

void AdaptiveTile::pilots(PixelSampler& sampler, const Deadline& deadline,
                          RenderStatistics& statistics) {
  const auto width = static_cast<std::size_t>(area_.width);
  pixels_.reserve(width * static_cast<std::size_t>(area_.height));
  const RenderPlan& plan = sampler.plan();
  const std::uint32_t first =
      std::min(pilot_samples, static_cast<std::uint32_t>(plan.options.max_samples));
  RenderStatistics counted;
  std::array<PilotRow, 3> rows{PilotRow(width + 2), PilotRow(width + 2), PilotRow(width + 2)};
  const auto row_of = [&](int y) -> PilotRow& {
    return rows[static_cast<std::size_t>(y - area_.y + 1) % 3];
  };
  RowContrast contrast(width + 2);
  std::vector<PixelSample> wanted;
  std::vector<std::optional<Rgb>> values((width + 2) * first);
  std::vector<std::uint8_t> quadrants(values.size());
  const int bottom = area_.y + area_.height;
  for (int y = area_.y - 1; y <= bottom; ++y) {
    if (deadline.told()) {
      release();
      return;
    }
    wanted.clear();
    for (int x = area_.x - 1; x <= area_.x + area_.width; ++x) {
      append_samples(wanted, x, y, 0, first);
    }
    RenderStatistics of_row;
    sampler.take_all(wanted, values, of_row, quadrants);
    of_row.bad_samples = 0;  // begin_row() counts those of the tile itself
    counted += of_row;
    PilotRow& pilots = row_of(y);
    for (std::size_t k = 0; k < width + 2; ++k) {
      pilots.set(k, std::span(values).subspan(k * first, first),
                 std::span(quadrants).subspan(k * first, first));
    }
    if (y >= area_.y && y < bottom) {
      begin_row(sampler, y, std::span(values).subspan(first, width * first), counted);
    }
    if (y > area_.y) {
      contrast.add_up({&row_of(y - 2), &row_of(y - 1), &row_of(y)});
      estimate({&pixels_[index(area_.x, y - 1)], width}, contrast, row_of(y - 1), first,
               plan.options.encoding);
    }
  }
  statistics += counted;
}

/// A row's pixels, from `values`, the first samples of each.
void AdaptiveTile::begin_row(PixelSampler& sampler, int y,
                             std::span<const std::optional<Rgb>> values,
                             RenderStatistics& statistics) {
  const RenderPlan& plan = sampler.plan();
  const auto most = static_cast<std::uint32_t>(plan.options.max_samples);
  const std::size_t first = values.size() / static_cast<std::size_t>(area_.width);
  for (int x = area_.x; x < area_.x + area_.width; ++x) {
    PixelEstimate& e = pixels_.emplace_back();
    for (const auto& value : values.first(first)) {
      if (!value) {
        statistics.add_bad(x, y);
      }
    }
    count_in(e, values.first(first), static_cast<std::uint32_t>(first));
    values = values.subspan(first);
    const int wanted = plan.thin ? thin_pilots(plan, x, y) : 0;
    while (static_cast<int>(e.count) < wanted && 2 * e.count <= most) {
      grow(sampler, e, x, y, 2 * e.count, statistics);
    }
    e.pilots = e.count;
  }
}

// In rounds over a row, so that neighbours fill packets together.
bool AdaptiveTile::refine(PixelSampler& sampler, double target, const Deadline& deadline,
                          RenderStatistics& statistics) {
  constexpr std::size_t batch = 256;
  const RenderPlan& plan = sampler.plan();
  const auto most = static_cast<std::uint32_t>(plan.options.max_samples);
  const int right = area_.x + area_.width;
  std::vector<PixelEstimate*> open;
  std::vector<PixelSample> wanted;
  for (int y = area_.y; y < area_.y + area_.height; ++y) {
    for (bool again = true; again;) {
      again = false;
      for (int x = area_.x; x < right;) {
        open.clear();
        wanted.clear();
        for (; x < right && wanted.size() < batch; ++x) {
          PixelEstimate& e = pixels_[index(x, y)];
          if (e.error > target && 2 * e.count <= most) {
            open.push_back(&e);
            append_samples(wanted, x, y, e.count, 2 * e.count);
          }
        }
        if (open.empty()) {
          continue;
        }
        if (deadline.passed()) {
          return false;
        }
        double_samples(sampler, open, wanted, plan.options.encoding, statistics);
        again = true;
      }
    }
  }
  return true;
}

void AdaptiveTile::save(ByteWriter& out) const {
  out.list(std::span(pixels_));
}

void AdaptiveTile::load(ByteReader& in, std::uint32_t most) {
  pixels_.assign(static_cast<std::size_t>(area_.width) * static_cast<std::size_t>(area_.height),
                 {});
  in.list(std::span(pixels_));
  for (const PixelEstimate& e : pixels_) {
    const std::uint32_t doublings = e.count / std::min(pilot_samples, most);
    const bool regular =
        std::has_single_bit(doublings) && doublings * std::min(pilot_samples, most) == e.count;
    if (!regular || e.count > most || e.pilots > e.count || e.bad > e.count) {
      throw std::out_of_range("no pixel");
    }
  }
}

}  // namespace rt
