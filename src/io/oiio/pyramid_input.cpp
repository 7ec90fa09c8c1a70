#include "pyramid_input.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace rt::io {
namespace {

constexpr const char* pyramid_attribute = "raytracer:pyramid";
constexpr const char* cache_attribute = "raytracer:cache";

std::atomic<std::uint64_t> peak{0};

std::uint64_t memory_in_use(OIIO::ImageCache& cache) {
  long long bytes = 0;
  cache.getattribute("stat:cache_memory_used", OIIO::TypeDesc::INT64, &bytes);
  const auto used = static_cast<std::uint64_t>(bytes);
  for (std::uint64_t seen = peak; used > seen && !peak.compare_exchange_weak(seen, used);) {
  }
  return used;
}

/// While one thread drops tiles to keep the cache within its limit, the others go on adding to it,
/// without bound where that one waits for a processor; and at ten times its limit the cache ends
/// the program. So a thread that comes for a tile waits while there is twice the limit, for at most
/// a second: the tiles that threads are using are not dropped.
void wait_for_memory(OIIO::ImageCache& cache) {
  float limit_megabytes = 0.0F;
  cache.getattribute("max_memory_MB", limit_megabytes);
  const auto limit = static_cast<std::uint64_t>(limit_megabytes) << 20;
  for (int i = 0; i < 10'000 && memory_in_use(cache) > 2 * limit; ++i) {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

/// Reads a pyramid for the cache, which may open several of these, one after the other.
class PyramidInput : public OIIO::ImageInput {
 public:
  const char* format_name() const override { return "pyramid"; }
  int supports(OIIO::string_view feature) const override { return feature == "mipmap"; }

  bool open(const std::string&, OIIO::ImageSpec&) override { return false; }

  bool open(const std::string&, OIIO::ImageSpec& spec, const OIIO::ImageSpec& config) override {
    const auto pointer = [&](const char* name) -> void* {
      const auto* attribute = config.find_attribute(name, OIIO::TypeDesc::PTR);
      return attribute == nullptr ? nullptr : *static_cast<void* const*>(attribute->data());
    };
    pyramid_ = static_cast<const Pyramid*>(pointer(pyramid_attribute));
    cache_ = static_cast<OIIO::ImageCache*>(pointer(cache_attribute));
    if (pyramid_ == nullptr || cache_ == nullptr || !seek_subimage(0, 0)) {
      return false;
    }
    spec = m_spec;
    return true;
  }

  bool close() override { return true; }
  int current_subimage() const override { return 0; }
  int current_miplevel() const override { return level_; }

  bool seek_subimage(int subimage, int level) override {
    if (subimage != 0 || level < 0 || level >= static_cast<int>(pyramid_->levels().size())) {
      return false;
    }
    const Pyramid::Level& at = pyramid_->levels()[static_cast<std::size_t>(level)];
    m_spec = OIIO::ImageSpec(at.width, at.height, pyramid_->channels(), pyramid_->type());
    m_spec.tile_width = m_spec.tile_height = Pyramid::tile;
    m_spec.tile_depth = 1;
    level_ = level;
    return true;
  }

  bool read_native_scanline(int, int, int, int, void*) override { return false; }

  bool read_native_tile(int, int level, int x, int y, int, void* pixels) override {
    wait_for_memory(*cache_);
    return pyramid_->read_tile(static_cast<std::size_t>(level), x, y, pixels);
  }

 private:
  const Pyramid* pyramid_ = nullptr;
  OIIO::ImageCache* cache_ = nullptr;
  int level_ = 0;
};

}  // namespace

bool add_pyramid(OIIO::ImageCache& cache, OIIO::ustring name, const Pyramid& pyramid) {
  const Pyramid* shown = &pyramid;
  OIIO::ImageCache* shown_cache = &cache;
  OIIO::ImageSpec config;
  config.attribute(pyramid_attribute, OIIO::TypeDesc::PTR, &shown);
  config.attribute(cache_attribute, OIIO::TypeDesc::PTR, &shown_cache);
  return cache.add_file(
      name, [] { return static_cast<OIIO::ImageInput*>(new PyramidInput); }, &config);
}

std::uint64_t cache_peak(OIIO::ImageCache& cache) {
  memory_in_use(cache);
  return peak;
}

void forget_cache_peak() { peak = 0; }

}  // namespace rt::io
