#include "rt/render/pixel.h"

#include <algorithm>
#include <cstdint>

namespace rt {
namespace {

constexpr double corner_tolerance = 0.1;

/// Samples asked for at a time.
constexpr int at_once = 64;

bool differ(const Rgb& a, const Rgb& b) {
  // What is brighter than the screen can show looks the same.
  return max_abs(glm::min(a, Rgb(1.0)) - glm::min(b, Rgb(1.0))) > corner_tolerance;
}

}  // namespace

bool uniform_row(PixelSampler& sampler, int x, int y, int count, std::span<Rgb> row,
                 const Deadline& deadline, RenderStatistics& statistics) {
  const auto pixels = static_cast<std::int64_t>(row.size());
  std::vector<PixelSample> wanted;
  std::vector<std::optional<Rgb>> values(at_once);
  std::vector<int> good(row.size());
  std::ranges::fill(row, Rgb(0.0));
  const std::int64_t all = pixels * count;
  PixelSample next{x, y, 0};
  for (std::int64_t begin = 0; begin < all; begin += at_once) {
    if (deadline.told()) {
      return false;
    }
    wanted.clear();
    const std::int64_t end = std::min(all, begin + at_once);
    for (std::int64_t i = begin; i < end; ++i) {
      wanted.push_back(next);
      if (++next.index == static_cast<std::uint32_t>(count)) {
        next = {next.x + 1, y, 0};
      }
    }
    sampler.take_all(wanted, values, statistics);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const auto pixel = static_cast<std::size_t>(wanted[i].x - x);
      if (values[i]) {
        row[pixel] += *values[i];
        ++good[pixel];
      }
    }
  }
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = good[i] > 0 ? row[i] / static_cast<double>(good[i]) : Rgb(0.0);
  }
  return true;
}

CornerTile::CornerTile(PixelSampler& sampler, const Crop& tile, RenderStatistics& statistics)
    : sampler_(sampler),
      tile_(tile),
      statistics_(statistics),
      inside_((edge + 1) * (edge + 1)),
      taken_(inside_.size()) {
  grid_.reserve(static_cast<std::size_t>(tile.width + 1) *
                static_cast<std::size_t>(tile.height + 1));
  for (int y = tile.y; y <= tile.y + tile.height; ++y) {
    for (int x = tile.x; x <= tile.x + tile.width; ++x) {
      grid_.push_back(traced(x, y, 0, 0));
    }
  }
}

Rgb CornerTile::value(int x, int y) {
  x_ = x;
  y_ = y;
  ++pixel_;
  return square(0, 0, edge);
}

Rgb CornerTile::traced(int x, int y, int i, int j) {
  const Vec2 offset{i / double{edge}, j / double{edge}};
  const Sampler sample(sampler_.plan().options.seed, x, y,
                       static_cast<std::uint32_t>(j * edge + i));
  return sampler_.take_at(x, y, offset, sample, statistics_).value_or(Rgb(0.0));
}

Rgb CornerTile::corner(int i, int j) {
  if (i % edge == 0 && j % edge == 0) {
    const int column = x_ - tile_.x + i / edge;
    const int row = y_ - tile_.y + j / edge;
    return grid_[static_cast<std::size_t>(row * (tile_.width + 1) + column)];
  }
  const auto slot = static_cast<std::size_t>(j * (edge + 1) + i);
  if (taken_[slot] != pixel_) {
    taken_[slot] = pixel_;
    // What lies on the right or lower edge is the neighbour's, with the neighbour's random numbers.
    inside_[slot] = traced(x_ + i / edge, y_ + j / edge, i % edge, j % edge);
  }
  return inside_[slot];
}

Rgb CornerTile::square(int i, int j, int size) {
  const Rgb a = corner(i, j);
  const Rgb b = corner(i + size, j);
  const Rgb c = corner(i, j + size);
  const Rgb d = corner(i + size, j + size);
  const bool uneven =
      differ(a, b) || differ(a, c) || differ(a, d) || differ(b, c) || differ(b, d) || differ(c, d);
  if (size == 1 || !uneven) {
    return 0.25 * (a + b + c + d);
  }
  const int half = size / 2;
  return 0.25 * (square(i, j, half) + square(i + half, j, half) + square(i, j + half, half) +
                 square(i + half, j + half, half));
}

}  // namespace rt
