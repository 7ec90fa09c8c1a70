#include "textures.h"

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/texture.h>

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>

#include "decode_texture.h"
#include "pyramid_input.h"
#include "reason.h"

namespace rt::io {

class ReadyTexture {
 public:
  OIIO::ustring name;
  OIIO::TextureSystem::TextureHandle* handle = nullptr;
  std::shared_ptr<const Pyramid> pyramid;
};

namespace {

/// One for the process, never destroyed: its threads may outlive main's statics.
OIIO::TextureSystem& texture_system() {
  static OIIO::TextureSystem* const system = [] {
    auto* made = OIIO::TextureSystem::create(false);
    made->attribute("max_errors_per_file", 1);
    return made;
  }();
  return *system;
}

/// Lookups of one thread: written by it alone.
using Counter = std::atomic<std::uint64_t>;

struct Counters {
  std::mutex mutex;
  std::deque<Counter> of_threads;  // stay when their thread ends
};
Counters& counters() {
  static auto* const all = new Counters;
  return *all;
}

Counter& new_counter() {
  Counters& all = counters();
  const std::lock_guard lock(all.mutex);
  return all.of_threads.emplace_back(0);
}

/// What a thread keeps between lookups.
struct ThreadState {
  OIIO::TextureSystem* system = &texture_system();
  OIIO::TextureSystem::Perthread* perthread = system->get_perthread_info();
  Counter* lookups = &new_counter();
};

OIIO::TextureOpt::Wrap wrap_of(TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::repeat:
      return OIIO::TextureOpt::WrapPeriodic;
    case TextureWrap::clamp:
      return OIIO::TextureOpt::WrapClamp;
    case TextureWrap::mirror:
      return OIIO::TextureOpt::WrapMirror;
    case TextureWrap::black:
      break;
  }
  return OIIO::TextureOpt::WrapBlack;
}

void spread_grey(float* rgb) { rgb[1] = rgb[2] = rgb[0]; }

}  // namespace

std::string make_texture(const TextureRequest& request, ReadyTexture*& texture, bool& is_encoded) {
  return guarded([&]() -> std::string {
    static std::atomic<unsigned> number{0};
    DecodedTexture decoded = decode_texture(request);
    is_encoded = decoded.is_encoded;
    auto ready = std::make_unique<ReadyTexture>();
    ready->pyramid = std::move(decoded.pyramid);
    ready->name = OIIO::ustring("texture " + std::to_string(++number) + " (" + request.name + ")");
    OIIO::TextureSystem& system = texture_system();
    if (!add_pyramid(*system.imagecache(), ready->name, *ready->pyramid)) {
      return reason_of(system.imagecache()->geterror());
    }
    ready->handle = system.get_texture_handle(ready->name);
    if (ready->handle == nullptr || !system.good(ready->handle)) {
      return reason_of(system.geterror());
    }
    texture = ready.release();
    return "";
  });
}

void drop_texture(ReadyTexture* texture) {
  guarded([&] {
    texture_system().invalidate(texture->name);
    delete texture;
    return "";
  });
}

bool look_up(const ReadyTexture& texture, const TextureLookup& lookup, bool derivatives,
             TextureResult& result) {
  static thread_local const ThreadState state;
  state.lookups->store(state.lookups->load(std::memory_order_relaxed) + 1,
                       std::memory_order_relaxed);
  const int channels = texture.pyramid->channels();
  OIIO::TextureOpt options;
  options.swrap = options.twrap = wrap_of(lookup.wrap);
  options.mipmode = OIIO::TextureOpt::MipModeAniso;
  options.interpmode =
      derivatives ? OIIO::TextureOpt::InterpSmartBicubic : OIIO::TextureOpt::InterpBilinear;
  const bool done = state.system->texture(
      texture.handle, state.perthread, options, lookup.s, lookup.t, lookup.ds_dx, lookup.dt_dx,
      lookup.ds_dy, lookup.dt_dy, channels, result.value, derivatives ? result.d_ds : nullptr,
      derivatives ? result.d_dt : nullptr);
  if (!done) {
    state.system->geterror();  // else it stays for the next that asks
    return false;
  }
  if (channels == 1) {
    spread_grey(result.value);
    if (derivatives) {
      spread_grey(result.d_ds);
      spread_grey(result.d_dt);
    }
  }
  return true;
}

void set_texture_memory(int megabytes) {
  static std::mutex mutex;
  static int now = 0;
  const std::lock_guard lock(mutex);
  if (megabytes != now) {
    // The cache aborts when it finds itself holding ten times what it may.
    texture_system().invalidate_all(true);
    texture_system().attribute("max_memory_MB", static_cast<float>(megabytes));
    now = megabytes;
    forget_cache_peak();
  }
}

TextureCounts texture_counts() {
  TextureCounts counts;
  {
    Counters& all = counters();
    const std::lock_guard lock(all.mutex);
    for (const Counter& counter : all.of_threads) {
      counts.lookups += counter.load(std::memory_order_relaxed);
    }
  }
  counts.cache_peak = cache_peak(*texture_system().imagecache());
  return counts;
}

}  // namespace rt::io
