#pragma once
/// Picture files byte by byte: whole, odd and broken ones, the same every time.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rt::io {

inline std::string number(std::uint64_t value, int bytes, bool big) {
  std::string text;
  for (int i = 0; i < bytes; ++i) {
    const int shift = 8 * (big ? bytes - 1 - i : i);
    text.push_back(shift < 64 ? static_cast<char>(value >> shift & 0xff) : '\0');
  }
  return text;
}
inline std::string be(std::uint64_t value, int bytes) { return number(value, bytes, true); }
inline std::string le(std::uint64_t value, int bytes) { return number(value, bytes, false); }

inline std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) {
      crc = crc >> 1 ^ (0xedb88320 & (0 - (crc & 1)));
    }
  }
  return ~crc;
}

/// A zlib stream of stored blocks.
inline std::string stored_zlib(const std::string& bytes) {
  std::string out("\x78\x01", 2);
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  for (std::size_t at = 0; at < bytes.size() || at == 0; at += 65535) {
    const std::string block = bytes.substr(at, 65535);
    out += static_cast<char>(at + 65535 >= bytes.size() ? 1 : 0);
    out += le(block.size(), 2) + le(0xffff ^ block.size(), 2) + block;
  }
  return out + be(b << 16 | a, 4);
}

inline std::string png_chunk(const std::string& kind, const std::string& data) {
  return be(data.size(), 4) + kind + data + be(crc32(kind + data), 4);
}

inline std::string png_start(std::uint32_t width, std::uint32_t height, int depth, int kind) {
  return std::string("\x89PNG\r\n\x1a\n", 8) +
         png_chunk("IHDR", be(width, 4) + be(height, 4) + static_cast<char>(depth) +
                               static_cast<char>(kind) + std::string(3, '\0'));
}

/// `rows` hold the packed samples of each row. `before` are chunks between header and data.
inline std::string png(std::uint32_t width, int depth, int kind,
                       const std::vector<std::string>& rows, const std::string& before = "",
                       const std::string& after = "") {
  std::string filtered;
  for (const std::string& row : rows) {
    filtered += '\0' + row;
  }
  return png_start(width, static_cast<std::uint32_t>(rows.size()), depth, kind) + before +
         png_chunk("IDAT", stored_zlib(filtered)) + after + png_chunk("IEND", "");
}

inline std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) {
    text.push_back(static_cast<char>(value));
  }
  return text;
}

/// 70 KB that claim to be a picture of that many pixels a side.
inline std::string png_bomb(std::uint32_t side) {
  return png_start(side, side, 8, 2) + png_chunk("IDAT", std::string(70'000, '\0'));
}

/// 24 bits a pixel, rows from the bottom; `pixels` are BGR.
inline std::string bmp(std::uint32_t width, std::uint32_t height, const std::string& pixels,
                       std::uint32_t compression = 0) {
  return "BM" + le(54 + pixels.size(), 4) + le(0, 4) + le(54, 4) + le(40, 4) + le(width, 4) +
         le(height, 4) + le(1, 2) + le(24, 2) + le(compression, 4) + le(pixels.size(), 4) +
         le(0, 16) + pixels;
}

/// Uncompressed, of `bits` a pixel, rows from the bottom.
inline std::string tga(int width, int height, int bits, const std::string& pixels) {
  return bytes({0, 0, bits == 8 ? 3 : 2}) + le(0, 9) + le(static_cast<unsigned>(width), 2) +
         le(static_cast<unsigned>(height), 2) + static_cast<char>(bits) + '\0' + pixels;
}

inline std::string hdr(const std::string& size, const std::string& pixels) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + pixels;
}

/// One IFD of 16-bit or 32-bit values: {tag, value}, in the order of their tags; all 8-bit samples.
inline std::string tiff(const std::vector<std::array<std::uint32_t, 2>>& tags,
                        const std::string& pixels) {
  std::string ifd = le(tags.size(), 2);
  for (const auto& [tag, value] : tags) {
    ifd += le(tag, 2) + le(4, 2) + le(1, 4) + le(value, 4);
  }
  const std::string head = std::string("II*\0", 4) + le(8 + pixels.size(), 4) + pixels;
  return head + ifd + le(0, 4);
}

inline std::string exr_attribute(const std::string& name, const std::string& type,
                                 const std::string& value) {
  return name + '\0' + type + '\0' + le(value.size(), 4) + value;
}

/// A header alone, for that data window.
inline std::string exr_header(std::int32_t x1, std::int32_t y1) {
  const std::string window =
      le(0, 8) + le(static_cast<std::uint32_t>(x1), 4) + le(static_cast<std::uint32_t>(y1), 4);
  const std::string channel = std::string("Y") + '\0' + le(1, 4) + le(0, 4) + le(1, 4) + le(1, 4);
  return std::string("\x76\x2f\x31\x01", 4) + le(2, 4) +
         exr_attribute("channels", "chlist", channel + '\0') +
         exr_attribute("compression", "compression", std::string(1, '\0')) +
         exr_attribute("dataWindow", "box2i", window) +
         exr_attribute("displayWindow", "box2i", window) +
         exr_attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
         exr_attribute("pixelAspectRatio", "float", le(0x3f800000, 4)) +
         exr_attribute("screenWindowCenter", "v2f", le(0, 8)) +
         exr_attribute("screenWindowWidth", "float", le(0x3f800000, 4)) + '\0';
}

}  // namespace rt::io
