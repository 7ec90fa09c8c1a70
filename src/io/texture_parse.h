#pragma once
/// Header parsers, one a format. Each throws Refused.
#include <array>
#include <bit>
#include <stdexcept>
#include <string>

#include "rt/io/texture_header.h"

namespace rt::io {

/// Why a picture is not read, without the file's name.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads numbers one after the other.
class Cursor {
 public:
  Cursor(const PictureFile& file, std::uint64_t start, std::endian order)
      : offset(start), file_(file), order_(order) {}

  std::uint64_t offset;

  std::uint64_t number(std::size_t bytes) {
    std::array<unsigned char, 8> raw{};
    read(raw.data(), bytes);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      value = value << 8 | raw[order_ == std::endian::big ? i : bytes - 1 - i];
    }
    return value;
  }
  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  std::int32_t i32() { return static_cast<std::int32_t>(u32()); }

  void read(void* bytes, std::size_t count) {
    if (file_.read(offset, bytes, count) != count) {
      throw Refused("it is cut short: it ends within its header");
    }
    offset += count;
  }

  /// Up to `end` or the file's end, without the mark; throws beyond `longest` bytes.
  std::string text_until(char end, std::size_t longest);

 private:
  const PictureFile& file_;
  std::endian order_;
};

PictureHeader parse_png(const PictureFile& file);
PictureHeader parse_jpeg(const PictureFile& file);
PictureHeader parse_bmp(const PictureFile& file);
PictureHeader parse_tga(const PictureFile& file);
PictureHeader parse_tiff(const PictureFile& file);
PictureHeader parse_exr(const PictureFile& file);
PictureHeader parse_hdr(const PictureFile& file);

/// Whether the header makes sense as one of TGA, and the footer or the name says that it is one.
bool looks_like_tga(const PictureFile& file);

}  // namespace rt::io
