#include "rt/render/adaptive.h"

#include "rt/render/thin.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace rt {
namespace {

/// The claimed error is so many standard deviations: chosen such that 95% of true errors lie below
/// 1.5 times the claim (bench/results/calibration.md).
constexpr double claim = 1.45;

/// What an estimate made before the last doubling still counts against the newest evidence.
constexpr double memory = 1.0;

constexpr double max_exponent = 1.5;

/// Counts the next samples in; there are to be `count` of them: above 4 so many as before, or
/// twice.
void count_in(PixelEstimate& e, std::span<const std::optional<Rgb>> values, std::uint32_t count) {
  if (e.count >= 4) {
    e.quarters = {e.quarters[0] + e.quarters[1], e.quarters[2] + e.quarters[3], Rgb(0.0), Rgb(0.0)};
  }
  const std::uint32_t quarter = std::max(count / 4, 1u);
  for (const auto& value : values) {
    if (value) {
      e.quarters[e.count / quarter] += *value;
      e.squares += *value * *value;
    } else {
      ++e.bad;
    }
    ++e.count;
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

/// The first samples of pixels that lie side by side, so that neighbours fill packets together.
void begin_row(PixelSampler& sampler, std::span<PixelEstimate> row, int x, int y,
               std::uint32_t count, RenderStatistics& statistics) {
  std::vector<PixelSample> wanted;
  wanted.reserve(row.size() * count);
  for (std::size_t k = 0; k < row.size(); ++k) {
    append_samples(wanted, x + static_cast<int>(k), y, 0, count);
  }
  std::vector<std::optional<Rgb>> values(wanted.size());
  sampler.take_all(wanted, values, statistics);
  for (std::size_t k = 0; k < row.size(); ++k) {
    count_in(row[k], std::span(values).subspan(k * count, count), count);
  }
}

/// How fast the variance of the mean has fallen, from one sample to half of those taken by now.
double observed_exponent(const PixelEstimate& e) {
  const double before = 0.5 * e.count;
  const Rgb mean = e.mean();
  const Rgb sample =
      glm::max(e.squares / std::max(1.0 * (e.count - e.bad), 1.0) - mean * mean, Rgb(0.0));
  const double of_samples = sample.r + sample.g + sample.b;
  const double of_mean = e.variance.r + e.variance.g + e.variance.b;
  if (!(of_samples > 0.0 && of_mean > 0.0)) {
    return max_exponent;
  }
  return std::clamp(std::log(of_samples / of_mean) / std::log(before), 1.0, max_exponent);
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
    const double rate = observed_exponent(*e);
    const Rgb expected = std::pow(0.5, rate) * e->variance;
    e->variance = (variance_of_quarters(*e, rate) + memory * expected) / (1.0 + memory);
    set_error(*e, encoding);
  }
}

}  // namespace

void AdaptiveTile::pilots(PixelSampler& sampler, const Deadline& deadline,
                          RenderStatistics& statistics) {
  pixels_.assign(
      static_cast<std::size_t>(area_.width + 2) * static_cast<std::size_t>(area_.height + 2), {});
  const RenderPlan& plan = sampler.plan();
  const auto most = static_cast<std::uint32_t>(plan.options.max_samples);
  const std::uint32_t first = std::min(pilot_samples, most);
  const int right = area_.x + area_.width;
  const int bottom = area_.y + area_.height;
  RenderStatistics within;
  RenderStatistics outside;
  for (int y = area_.y - 1; y <= bottom; ++y) {
    if (deadline.told()) {
      release();
      return;
    }
    const bool row_inside = y >= area_.y && y < bottom;
    const std::span row(&pixels_[index(area_.x - 1, y)], static_cast<std::size_t>(area_.width + 2));
    begin_row(sampler, row.first(1), area_.x - 1, y, first, outside);
    begin_row(sampler, row.subspan(1, row.size() - 2), area_.x, y, first,
              row_inside ? within : outside);
    begin_row(sampler, row.last(1), right, y, first, outside);
    for (int x = area_.x - 1; x <= right; ++x) {
      const bool inside = row_inside && x >= area_.x && x < right;
      RenderStatistics& counts = inside ? within : outside;
      PixelEstimate& e = pixels_[index(x, y)];
      const int wanted = plan.thin ? thin_pilots(plan, x, y) : 0;
      while (static_cast<int>(e.count) < wanted && 2 * e.count <= most) {
        grow(sampler, e, x, y, 2 * e.count, counts);
      }
      e.pilots = e.count;
    }
  }
  outside.bad_samples = 0;  // they count in the tile that they belong to
  statistics += within;
  statistics += outside;
  estimate_from_contrast(plan);
}

// Each pixel's share is formed once, for the nine that it counts for.
void AdaptiveTile::estimate_from_contrast(const RenderPlan& plan) {
  struct Share {
    Rgb mean, square;
  };
  std::vector<Share> shares;
  shares.reserve(pixels_.size());
  for (const PixelEstimate& e : pixels_) {
    shares.push_back({e.mean() / 9.0, e.squares / (9.0 * std::max(e.count - e.bad, 1u))});
  }
  const auto most = static_cast<std::uint32_t>(plan.options.max_samples);
  const double of_pilots = std::pow(std::min(pilot_samples, most), -max_exponent);
  for (int y = area_.y; y < area_.y + area_.height; ++y) {
    for (int x = area_.x; x < area_.x + area_.width; ++x) {
      Rgb mean(0.0);
      Rgb square(0.0);
      for (int j = y - 1; j <= y + 1; ++j) {
        for (int i = x - 1; i <= x + 1; ++i) {
          mean += shares[index(i, j)].mean;
          square += shares[index(i, j)].square;
        }
      }
      PixelEstimate& e = pixels_[index(x, y)];
      const Rgb contrast = glm::max(square - mean * mean, Rgb(0.0));
      e.variance = contrast * of_pilots;
      if (e.count > pilot_samples) {
        // So many pilots for the sake of something thin: their own scatter is evidence, too.
        e.variance = contrast * std::pow(e.count, -max_exponent);
        e.variance = 0.5 * (e.variance + variance_of_quarters(e, 0.5 * (1.0 + max_exponent)));
      }
      set_error(e, plan.options.encoding);
    }
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
  for (int y = area_.y; y < area_.y + area_.height; ++y) {
    out.list(std::span(&at(area_.x, y), static_cast<std::size_t>(area_.width)));
  }
}

void AdaptiveTile::load(ByteReader& in, std::uint32_t most) {
  pixels_.assign(
      static_cast<std::size_t>(area_.width + 2) * static_cast<std::size_t>(area_.height + 2), {});
  for (int y = area_.y; y < area_.y + area_.height; ++y) {
    const std::span row(&pixels_[index(area_.x, y)], static_cast<std::size_t>(area_.width));
    in.list(row);
    for (const PixelEstimate& e : row) {
      const std::uint32_t doublings = e.count / std::min(pilot_samples, most);
      const bool regular =
          std::has_single_bit(doublings) && doublings * std::min(pilot_samples, most) == e.count;
      if (!regular || e.count > most || e.pilots > e.count || e.bad > e.count) {
        throw std::out_of_range("no pixel");
      }
    }
  }
}

}  // namespace rt
