#include "pyramid.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace rt::io {
namespace {

[[noreturn]] void fail(int error) {
  throw std::runtime_error("there is no room for what it decodes to in " +
                           std::filesystem::temp_directory_path().string() + " (" +
                           std::generic_category().message(error) +
                           "); name another folder by TMPDIR");
}

/// A file that has no name any more, so that it goes when the process does.
int nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "raytracer-texture-XXXXXX").string();
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) {
    fail(errno);
  }
  ::unlink(name.c_str());
  return file;
}

/// The weights of source pixels 2i, 2i + 1 and 2i + 2 in pixel i of n / 2: the box filter over
/// [i, i + 1) n / (n / 2). With n = 2k they are 1/2, 1/2, 0; with n = 2k + 1 each pixel spans
/// 2 + 1/k pixels, beginning i/k into pixel 2i. Each pixel counts alike in the sum over i, so that
/// the mean of the picture is kept.
struct Taps {
  float first, second, third;
};
Taps taps(int n, int i) {
  if (n == 1) {
    return {1.0F, 0.0F, 0.0F};
  }
  if (n % 2 == 0) {
    return {0.5F, 0.5F, 0.0F};
  }
  const int k = n / 2;
  const double scale = 1.0 / n;
  return {static_cast<float>(scale * (k - i)), static_cast<float>(scale * k),
          static_cast<float>(scale * (i + 1))};
}

}  // namespace

Pyramid::Pyramid(int width, int height, int channels, OIIO::TypeDesc type)
    : channels_(channels), type_(type) {
  std::int64_t offset = 0;
  for (Level level{width, height, 0};;
       level.width = std::max(1, level.width / 2), level.height = std::max(1, level.height / 2)) {
    level.offset = offset;
    offset += static_cast<std::int64_t>(tile_bytes()) * level.tiles_across() * level.tiles_down();
    levels_.push_back(level);
    const auto wide = static_cast<std::size_t>(level.tiles_across()) * tile;
    const auto values = static_cast<std::size_t>(channels);
    const auto half = static_cast<std::size_t>(std::max(1, level.width / 2)) * values;
    progress_.push_back({0, std::vector<float>(wide * tile * values), std::vector<float>(half),
                         std::vector<float>(half)});
    if (level.width == 1 && level.height == 1) {
      break;
    }
  }
  packed_.resize(tile_bytes());
  file_ = nameless_file();
}

Pyramid::~Pyramid() { ::close(file_); }

std::size_t Pyramid::tile_bytes() const {
  return type_.size() * static_cast<std::size_t>(channels_) * tile * tile;
}

void Pyramid::narrow_row(const Level& from, const Level& to, const float* row, float* out) const {
  for (int i = 0; i < to.width; ++i) {
    const Taps w = taps(from.width, i);
    const float* source = row + std::ptrdiff_t{2} * i * channels_;
    for (int c = 0; c < channels_; ++c) {
      float sum = w.first * source[c];
      sum += w.second != 0.0F ? w.second * source[c + channels_] : 0.0F;
      sum += w.third != 0.0F ? w.third * source[c + 2 * channels_] : 0.0F;
      *out++ = sum;
    }
  }
}

void Pyramid::push_row(const float* row) {
  push_row(0, row);
  if (progress_.front().rows == levels_.front().height) {
    progress_ = {};
    packed_ = {};
  }
}

void Pyramid::push_row(std::size_t index, const float* row) {
  const Level& level = levels_[index];
  Progress& state = progress_[index];
  const int y = state.rows++;
  const auto values = static_cast<std::size_t>(level.width) * static_cast<std::size_t>(channels_);
  const std::size_t stride = static_cast<std::size_t>(level.tiles_across() * tile * channels_);
  std::copy_n(row, values, state.strip.data() + static_cast<std::size_t>(y % tile) * stride);
  if (state.rows % tile == 0 || state.rows == level.height) {
    write_strip(index);
  }
  if (index + 1 == levels_.size()) {
    return;
  }
  const Level& next = levels_[index + 1];
  narrow_row(level, next, row, state.narrow.data());
  // Row y is the first, second or third that some row i of the next level is made of; when the
  // height is odd, both the third of one and the first of the next.
  const auto add = [&](float weight) {
    for (std::size_t k = 0; k < state.sum.size(); ++k) {
      state.sum[k] += weight * state.narrow[k];
    }
  };
  const auto finish = [&] {
    push_row(index + 1, state.sum.data());
    std::ranges::fill(state.sum, 0.0F);
  };
  const bool odd = level.height % 2 != 0 && level.height > 1;
  if (odd && y % 2 == 0 && y > 0) {
    add(taps(level.height, y / 2 - 1).third);
    finish();
  }
  if (y / 2 < next.height) {
    const Taps w = taps(level.height, y / 2);
    add(y % 2 == 0 ? w.first : w.second);
    if (!odd && (y % 2 != 0 || level.height == 1)) {
      finish();
    }
  }
}

/// Writes the row of tiles that ends with the latest row of pixels; what lies beyond the picture
/// repeats nothing in particular: no lookup reads it.
void Pyramid::write_strip(std::size_t index) {
  const Level& level = levels_[index];
  Progress& state = progress_[index];
  const int across = level.tiles_across();
  const int down = (state.rows - 1) / tile;
  const auto row_values = static_cast<std::size_t>(tile) * static_cast<std::size_t>(channels_);
  const std::size_t row_bytes = row_values * type_.size();
  for (int i = 0; i < across; ++i) {
    for (std::size_t y = 0; y < tile; ++y) {
      const float* source =
          state.strip.data() +
          (y * static_cast<std::size_t>(across) + static_cast<std::size_t>(i)) * row_values;
      OIIO::convert_pixel_values(OIIO::TypeFloat, source, type_, packed_.data() + y * row_bytes,
                                 static_cast<int>(row_values));
    }
    const auto at =
        level.offset + static_cast<std::int64_t>(tile_bytes()) * (std::int64_t{down} * across + i);
    for (std::size_t done = 0; done < packed_.size();) {
      const auto wrote = ::pwrite(file_, packed_.data() + done, packed_.size() - done,
                                  at + static_cast<std::int64_t>(done));
      if (wrote <= 0) {
        fail(wrote < 0 ? errno : ENOSPC);
      }
      done += static_cast<std::size_t>(wrote);
    }
  }
}

bool Pyramid::read_tile(std::size_t index, int x, int y, void* pixels) const {
  const Level& level = levels_[index];
  const auto number = std::int64_t{y / tile} * level.tiles_across() + x / tile;
  const auto at = level.offset + static_cast<std::int64_t>(tile_bytes()) * number;
  std::size_t done = 0;
  while (done < tile_bytes()) {
    const auto got = ::pread(file_, static_cast<char*>(pixels) + done, tile_bytes() - done,
                             at + static_cast<std::int64_t>(done));
    if (got <= 0) {
      return false;
    }
    done += static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace rt::io
