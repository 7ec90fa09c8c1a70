#include "rt/render/pixel.h"

#include <algorithm>
#include <array>

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

Rgb uniform_pixel(PixelSampler& sampler, int x, int y, int count, RenderStatistics& statistics) {
  Rgb sum(0.0);
  int good = 0;
  std::vector<PixelSample> wanted;
  std::array<std::optional<Rgb>, at_once> values;
  for (int i = 0; i < count; i += at_once) {
    wanted.clear();
    for (int k = i; k < std::min(count, i + at_once); ++k) {
      wanted.push_back({x, y, static_cast<std::uint32_t>(k), count == 1});
    }
    sampler.take_all(wanted, values, statistics);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (values[k]) {
        sum += *values[k];
        ++good;
      }
    }
  }
  return good > 0 ? sum / static_cast<double>(good) : Rgb(0.0);
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
