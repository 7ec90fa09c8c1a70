#include "rt/io/texture_header.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "rt/scene/error.h"
#include "texture_parse.h"

namespace rt::io {
namespace {

using namespace std::string_view_literals;

struct Kind {
  std::string_view magic;  ///< how its files begin
  PictureHeader (*parse)(const PictureFile&);
};

constexpr std::array kinds{
    Kind{"\x89PNG\r\n\x1a\n"sv, parse_png},
    Kind{"\xff\xd8\xff"sv, parse_jpeg},
    Kind{"BM"sv, parse_bmp},
    Kind{"II*\0"sv, parse_tiff},
    Kind{"MM\0*"sv, parse_tiff},
    Kind{"II+\0"sv, parse_tiff},
    Kind{"MM\0+"sv, parse_tiff},
    Kind{"\x76\x2f\x31\x01"sv, parse_exr},
    Kind{"#?RADIANCE"sv, parse_hdr},
    Kind{"#?RGBE"sv, parse_hdr},
};

PictureHeader parse(const PictureFile& file) {
  std::array<char, 12> start{};
  const std::string_view seen(start.data(), file.read(0, start.data(), start.size()));
  for (const Kind& kind : kinds) {
    if (seen.starts_with(kind.magic)) {
      return kind.parse(file);
    }
  }
  if (looks_like_tga(file)) {
    return parse_tga(file);
  }
  const bool is_gif = seen.starts_with("GIF8");
  throw Refused(fmt::format("expected a PNG, JPEG, BMP, TGA, TIFF, EXR or HDR picture, got {}",
                            is_gif ? "a GIF; save it as PNG" : "a file that holds none of these"));
}

void check(const PictureFile& file, const PictureHeader& header, const TextureLimits& limits) {
  const auto largest = static_cast<std::uint64_t>(limits.largest_side);
  if (header.width == 0 || header.height == 0 || header.channels == 0) {
    throw Refused(fmt::format("its header claims {} x {} pixels of {} channels", header.width,
                              header.height, header.channels));
  }
  if (header.width > largest || header.height > largest) {
    throw Refused(fmt::format(
        "its header claims {} x {} pixels, but at most {} a side are read; make it smaller, or "
        "allow more by --max-texture-size",
        header.width, header.height, largest));
  }
  // No overflow: sides are below 2^31, and the parsers keep channels below 2^16.
  const std::uint64_t values = header.width * header.height;
  if (values > limits.decoded_bytes / (header.channels * header.channel_bytes)) {
    throw Refused(fmt::format(
        "decoded, its {} x {} pixels of {} channels would take more than {} MB; make it smaller",
        header.width, header.height, header.channels, limits.decoded_bytes >> 20));
  }
  if (file.size() < header.least_file_bytes) {
    throw Refused(fmt::format("it is cut short: {} bytes cannot hold its {} x {} pixels",
                              file.size(), header.width, header.height));
  }
  constexpr std::uint64_t beside = std::uint64_t{64} << 20;  // profiles, thumbnails
  if (file.size() > limits.decoded_bytes + beside) {
    throw Refused(fmt::format("{} MB are too large a file for a texture", file.size() >> 20));
  }
}

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view reason) {
  throw FileError(fmt::format("cannot read the picture '{}': {}", path.string(), reason));
}

}  // namespace

PictureFile::PictureFile(std::filesystem::path path) : path_(std::move(path)) {
  struct stat status {};
  // First by name: opening a device or a pipe may do more than look.
  if (::stat(path_.c_str(), &status) != 0) {
    refuse(path_, std::generic_category().message(errno));
  }
  if (!S_ISREG(status.st_mode)) {
    refuse(path_, S_ISDIR(status.st_mode) ? "it is a folder" : "it is not a regular file");
  }
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor_ < 0) {
    refuse(path_, std::generic_category().message(errno));
  }
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size <= 0) {
    ::close(descriptor_);
    refuse(path_, S_ISREG(status.st_mode) ? "it is empty" : "it is not a regular file");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

PictureFile::~PictureFile() { ::close(descriptor_); }

std::size_t PictureFile::read(std::uint64_t offset, void* bytes, std::size_t count) const {
  std::size_t done = 0;
  while (done < count && offset + done < size_) {
    const auto got = ::pread(descriptor_, static_cast<char*>(bytes) + done, count - done,
                             static_cast<off_t>(offset + done));
    if (got <= 0) {
      break;
    }
    done += static_cast<std::size_t>(got);
  }
  return done;
}

PictureHeader check_picture(const PictureFile& file, const TextureLimits& limits) {
  try {
    PictureHeader header = parse(file);
    check(file, header, limits);
    if (header.readable_bytes == 0) {
      header.readable_bytes = file.size();
    }
    return header;
  } catch (const Refused& reason) {
    refuse(file.path(), reason.what());
  }
}

}  // namespace rt::io
