// Fuzz target: a picture for a texture.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "rt/io/texture.h"
#include "rt/io/texture_header.h"
#include "rt/scene/error.h"
#include "rt/scene/texture.h"

namespace {

void check(const rt::Rgb& c) {
  if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) {
    std::abort();
  }
}

/// A side of 64 and 64 KB: decoders are tried, not how much of their time a file may take.
constexpr rt::io::TextureLimits limits{.largest_side = 64, .decoded_bytes = 1 << 16};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // By this name whatever looks like a TGA is taken for one.
  static const std::filesystem::path file = [] {
    char pattern[] = "/tmp/rt-fuzz-XXXXXX";
    return std::filesystem::path(mkdtemp(pattern)) / "picture.tga";
  }();
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const rt::io::PictureHeader header = check_picture(rt::io::PictureFile(file), limits);
    const auto side = static_cast<std::uint64_t>(limits.largest_side);
    if (header.width == 0 || header.width > side || header.height == 0 || header.height > side ||
        header.width * header.height * header.channels * header.channel_bytes >
            limits.decoded_bytes) {
      std::abort();
    }
    const auto image = rt::io::open_texture(file, limits);
    check(image->value({{0.3, 0.6}, {0.1, 0.0}, {0.0, 0.2}}, rt::Wrap::repeat, false));
    check(image->sample({{0.9, -0.6}}, rt::Wrap::mirror, true).d_dv);
  } catch (const rt::UserError&) {
  }
  return 0;
}
