#include "rt/io/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

#include "oiio_loader.h"
#include "rt/io/texture_header.h"
#include "rt/scene/error.h"
#include "rt/scene/texture.h"

namespace rt::io {
namespace {

std::atomic<std::uint64_t> files_opened{0};
std::atomic<std::int64_t> load_nanoseconds{0};

/// Adds the time it lives to load_nanoseconds.
class LoadTimer {
 public:
  LoadTimer() = default;
  LoadTimer(const LoadTimer&) = delete;
  LoadTimer& operator=(const LoadTimer&) = delete;
  ~LoadTimer() {
    load_nanoseconds += std::chrono::nanoseconds(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

TextureWrap module_wrap(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return TextureWrap::repeat;
    case Wrap::clamp:
      return TextureWrap::clamp;
    case Wrap::mirror:
      return TextureWrap::mirror;
    case Wrap::black:
      break;
  }
  return TextureWrap::black;
}

/// A coordinate in the range where the picture is, or near it, so that float holds it to a small
/// part of a texel; in double, where taking away whole periods is exact up to one rounding. Without
/// a period, beyond 2^16 widths all is the edge or black for any footprint that `bounded` leaves.
float reduced(double x, Wrap wrap) {
  if (!std::isfinite(x)) {
    return 0.5F;
  }
  constexpr double far = 65536.0;
  switch (wrap) {
    case Wrap::repeat:
      return static_cast<float>(x - std::floor(x));
    case Wrap::mirror:
      return static_cast<float>(x - 2.0 * std::floor(0.5 * x));
    default:
      return static_cast<float>(std::clamp(x, -far, far));
  }
}

/// A change of a coordinate; over 64 widths of the picture there is nothing but its mean to be
/// seen, and OpenImageIO squares what it is given.
float bounded(double change) {
  constexpr double most = 64.0;
  return static_cast<float>(std::isnan(change) ? most : std::clamp(change, -most, most));
}

/// The picture's t goes down.
TextureLookup lookup_of(const TextureFootprint& footprint, Wrap wrap) {
  return {reduced(footprint.uv.x, wrap),
          reduced(1.0 - footprint.uv.y, wrap),
          bounded(footprint.duv_dx.x),
          -bounded(footprint.duv_dx.y),
          bounded(footprint.duv_dy.x),
          -bounded(footprint.duv_dy.y),
          module_wrap(wrap)};
}

Rgb rgb(const float* values) { return {values[0], values[1], values[2]}; }

class FileTexture : public TextureImage {
 public:
  FileTexture(const std::filesystem::path& path, const TextureLimits& limits)
      : file_(path), limits_(limits), header_(check_picture(file_, limits)), table_(oiio()) {
    table_.set_texture_memory(limits.cache_megabytes);
    bool is_encoded = false;
    linear_ = made(false, is_encoded);
    has_raw_ = is_encoded;
  }
  ~FileTexture() override {
    for (ReadyTexture* texture : {linear_, raw_}) {
      if (texture != nullptr) {
        table_.drop_texture(texture);
      }
    }
  }

  const std::filesystem::path& file() const override { return file_.path(); }

  Rgb value(const TextureFootprint& footprint, Wrap wrap, bool raw) const override {
    return rgb(looked_up(footprint, wrap, raw, false).value);
  }

  TextureSample sample(const TextureFootprint& footprint, Wrap wrap, bool raw) const override {
    const TextureResult result = looked_up(footprint, wrap, raw, true);
    return {rgb(result.value), rgb(result.d_ds), -rgb(result.d_dt)};
  }

 private:
  TextureResult looked_up(const TextureFootprint& footprint, Wrap wrap, bool raw,
                          bool derivatives) const {
    TextureResult result{};
    const ReadyTexture& texture = raw && has_raw_ ? raw_texture() : *linear_;
    if (!table_.look_up(texture, lookup_of(footprint, wrap), derivatives, result)) {
      fail("what was decoded of it cannot be read again");
    }
    return result;
  }

  ReadyTexture& raw_texture() const {
    std::call_once(once_, [this] {
      bool ignored = false;
      raw_ = made(true, ignored);
    });
    return *raw_;
  }

  ReadyTexture* made(bool raw, bool& is_encoded) const {
    const TextureRequest request{.reader = header_.reader,
                                 .name = file_.path().c_str(),
                                 .descriptor = file_.descriptor(),
                                 .readable_bytes = header_.readable_bytes,
                                 .decoded_bytes = limits_.decoded_bytes,
                                 .largest_side = limits_.largest_side,
                                 .raw = raw};
    ReadyTexture* texture = nullptr;
    if (const std::string reason = table_.make_texture(request, texture, is_encoded);
        !reason.empty()) {
      fail(reason);
    }
    return texture;
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(fmt::format("cannot read the picture '{}', a {} file: {}",
                                file_.path().string(), header_.format, reason));
  }

  PictureFile file_;
  TextureLimits limits_;
  PictureHeader header_;
  const OiioTable& table_;
  ReadyTexture* linear_ = nullptr;
  bool has_raw_ = false;  ///< raw values differ
  mutable std::once_flag once_;
  mutable ReadyTexture* raw_ = nullptr;
};

}  // namespace

std::shared_ptr<const TextureImage> open_texture(const std::filesystem::path& path,
                                                 const TextureLimits& limits) {
  const LoadTimer timer;
  auto texture = std::make_shared<const FileTexture>(path, limits);
  ++files_opened;
  return texture;
}

TextureStatistics texture_statistics() {
  TextureStatistics statistics;
  statistics.files = files_opened;
  if (statistics.files > 0) {
    const TextureCounts counts = oiio().texture_counts();
    statistics.lookups = counts.lookups;
    statistics.cache_peak = counts.cache_peak;
    statistics.load_seconds = 1e-9 * static_cast<double>(load_nanoseconds);
  }
  return statistics;
}

}  // namespace rt::io
