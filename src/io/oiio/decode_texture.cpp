#include "decode_texture.h"

#include <OpenImageIO/filesystem.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "reason.h"
#include "rt/io/encoding.h"

namespace rt::io {
namespace {

/// Part of an open file, as OpenImageIO's readers see it.
class FilePart : public OIIO::Filesystem::IOProxy {
 public:
  FilePart(int descriptor, std::uint64_t size, const char* name)
      : IOProxy(name, Read), descriptor_(descriptor), size_(size) {}

  const char* proxytype() const override { return "part of a file"; }
  std::size_t size() const override { return size_; }
  std::size_t read(void* bytes, std::size_t count) override {
    const std::size_t got = pread(bytes, count, m_pos);
    m_pos += static_cast<std::int64_t>(got);
    return got;
  }
  std::size_t pread(void* bytes, std::size_t count, std::int64_t offset) override {
    if (offset < 0 || static_cast<std::uint64_t>(offset) >= size_) {
      return 0;
    }
    count = std::min<std::size_t>(count, size_ - static_cast<std::uint64_t>(offset));
    std::size_t done = 0;
    while (done < count) {
      const auto got = ::pread(descriptor_, static_cast<char*>(bytes) + done, count - done,
                               offset + static_cast<std::int64_t>(done));
      if (got <= 0) {
        break;
      }
      done += static_cast<std::size_t>(got);
    }
    return done;
  }

 private:
  int descriptor_;
  std::uint64_t size_;
};

/// The reader's view of the file: JPEG's takes no proxies but OpenImageIO's own.
struct Source {
  explicit Source(const TextureRequest& request) {
    if (std::string_view(request.reader) == "jpeg") {
      stream.reset(::fdopen(::dup(request.descriptor), "rb"));
      if (!stream || std::fseek(stream.get(), 0, SEEK_SET) != 0) {
        throw std::runtime_error("it cannot be opened a second time");
      }
      proxy = std::make_unique<OIIO::Filesystem::IOFile>(stream.get(), FilePart::Read);
    } else {
      proxy = std::make_unique<FilePart>(request.descriptor, request.readable_bytes, request.name);
    }
  }

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> stream;
  std::unique_ptr<OIIO::Filesystem::IOProxy> proxy;
};

/// libpng and libjpeg write what they find wrong to stderr, and OpenImageIO gives no way to stop
/// them. While it lives that goes nowhere, so that a broken file makes one message. glibc's stderr
/// is a variable; what writes to descriptor 2 is not touched.
class QuietLibraries {
 public:
  QuietLibraries() : nowhere_(std::fopen("/dev/null", "w")) {
    if (nowhere_ != nullptr) {
      stderr = nowhere_;
    }
  }
  QuietLibraries(const QuietLibraries&) = delete;
  QuietLibraries& operator=(const QuietLibraries&) = delete;
  ~QuietLibraries() {
    stderr = before_;
    if (nowhere_ != nullptr) {
      std::fclose(nowhere_);
    }
  }

 private:
  std::FILE* before_ = stderr;
  std::FILE* nowhere_;
};

/// srgb_eotf() at k / top for k = 0 ... top.
std::vector<float> linearising_table(std::size_t top) {
  std::vector<float> table(top + 1);
  for (std::size_t k = 0; k <= top; ++k) {
    table[k] = static_cast<float>(srgb_eotf(static_cast<double>(k) / static_cast<double>(top)));
  }
  return table;
}

/// Values of integer pictures, which come as k / top up to rounding far below a half.
void linearise(std::vector<float>& values, const std::vector<float>& table) {
  const auto top = static_cast<float>(table.size() - 1);
  for (float& x : values) {
    x = table[static_cast<std::size_t>(std::clamp(x, 0.0F, 1.0F) * top + 0.5F)];
  }
}

/// Beyond this a float picture's value says nothing, and sums of them could overflow.
constexpr float largest = 1e30F;

void make_finite(std::vector<float>& values) {
  for (float& x : values) {
    x = std::isfinite(x) ? std::clamp(x, -largest, largest) : 0.0F;
  }
}

/// How many rows to read at a time: whole tiles, or as many as a row of the pyramid's tiles has.
int rows_at_a_time(const OIIO::ImageSpec& spec) {
  return spec.tile_height > 0 ? spec.tile_height : Pyramid::tile;
}

int channels_kept(const OIIO::ImageSpec& spec) { return spec.nchannels >= 3 ? 3 : 1; }

void check(const OIIO::ImageSpec& spec, const TextureRequest& request) {
  const auto bytes = static_cast<std::uint64_t>(std::max(spec.width, 0)) *
                     static_cast<std::uint64_t>(std::max(spec.height, 0)) * spec.pixel_bytes(true);
  if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels <= 0 || spec.deep ||
      spec.width > request.largest_side || spec.height > request.largest_side ||
      bytes > request.decoded_bytes) {
    throw std::runtime_error("its reader found " + std::to_string(spec.width) + " x " +
                             std::to_string(spec.height) + " pixels of " +
                             std::to_string(spec.nchannels) + " channels, which is too much");
  }
  // A file may say that its tiles are far larger than the picture.
  const auto row = static_cast<std::uint64_t>(std::max(spec.width, spec.tile_width)) *
                   static_cast<std::uint64_t>(channels_kept(spec)) * sizeof(float);
  if (row * static_cast<std::uint64_t>(rows_at_a_time(spec)) > request.decoded_bytes) {
    throw std::runtime_error("its reader found tiles of " + std::to_string(spec.tile_width) +
                             " x " + std::to_string(spec.tile_height) +
                             " pixels, which is too much");
  }
}

void read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int y, int end, int channels,
               float* rows) {
  const int y0 = spec.y + y;
  const int y1 = spec.y + end;
  const bool done =
      spec.tile_width > 0
          ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, y0, y1, spec.z, spec.z + 1, 0,
                             channels, OIIO::TypeFloat, rows)
          : input.read_scanlines(0, 0, y0, y1, spec.z, 0, channels, OIIO::TypeFloat, rows);
  if (!done) {
    throw std::runtime_error(reason_of(input.geterror()));
  }
}

}  // namespace

DecodedTexture decode_texture(const TextureRequest& request) {
  // Only once for a file, before anything is rendered: no other thread writes to stderr then.
  std::optional<QuietLibraries> quiet;
  if (!request.raw) {
    quiet.emplace();
  }
  const Source source(request);
  auto input = OIIO::ImageInput::create(request.reader);
  if (!input) {
    throw std::runtime_error(reason_of(OIIO::geterror()));
  }
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);  // no multiplication by alpha: stored values
  OIIO::ImageSpec spec;
  input->set_ioproxy(source.proxy.get());
  if (!input->open(request.name, spec, hints)) {
    throw std::runtime_error(reason_of(input->geterror()));
  }
  check(spec, request);
  const int channels = channels_kept(spec);
  const auto bits = spec.format.size() * 8;
  DecodedTexture decoded;
  decoded.is_encoded = !spec.format.is_floating_point() && bits <= 16;
  // Half holds 8 bits, linearised or not, to 2^-11 of the value.
  const bool fits_half = bits == 8 || spec.format == OIIO::TypeHalf;
  auto pyramid = std::make_shared<Pyramid>(spec.width, spec.height, channels,
                                           fits_half ? OIIO::TypeHalf : OIIO::TypeFloat);
  std::vector<float> table;
  if (decoded.is_encoded && !request.raw) {
    table = linearising_table(bits == 8 ? 255 : 65535);
  }
  const auto row_values = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(channels);
  const int step = rows_at_a_time(spec);
  std::vector<float> rows(row_values * static_cast<std::size_t>(step));
  for (int y = 0; y < spec.height; y += step) {
    const int end = std::min(y + step, spec.height);
    read_rows(*input, spec, y, end, channels, rows.data());
    if (!table.empty()) {
      linearise(rows, table);
    } else if (!decoded.is_encoded) {
      make_finite(rows);
    }
    for (int i = 0; i < end - y; ++i) {
      pyramid->push_row(rows.data() + static_cast<std::size_t>(i) * row_values);
    }
  }
  decoded.pyramid = std::move(pyramid);
  return decoded;
}

}  // namespace rt::io
