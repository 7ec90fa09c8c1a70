/// PNG, JPEG, BMP, TGA, HDR: headers with everything in a fixed place, or nearly.
#include <algorithm>
#include <charconv>
#include <string_view>

#include "texture_parse.h"

namespace rt::io {
namespace {

std::uint64_t up(std::uint64_t value, std::uint64_t divisor) {
  return (value + divisor - 1) / divisor;
}

std::uint64_t magnitude(std::int32_t value) {
  return value < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(std::int64_t{value})
                   : static_cast<std::uint64_t>(value);
}

}  // namespace

std::string Cursor::text_until(char end, std::size_t longest) {
  std::string text;
  for (char c = 0; file_.read(offset, &c, 1) == 1; text.push_back(c)) {
    ++offset;
    if (c == end) {
      return text;
    }
    if (text.size() == longest) {
      throw Refused("its header makes no sense");
    }
  }
  throw Refused("it is cut short: it ends within its header");
}

PictureHeader parse_png(const PictureFile& file) {
  Cursor at(file, 8, std::endian::big);
  if (at.u32() != 13 || at.u32() != 0x49484452) {  // "IHDR"
    throw Refused("it begins as a PNG file, but has no PNG header");
  }
  PictureHeader header{"PNG", "png"};
  header.width = at.u32();
  header.height = at.u32();
  const std::uint64_t depth = at.u8();
  const std::uint64_t kind = at.u8();
  constexpr std::array<std::uint64_t, 7> stored{1, 0, 3, 1, 2, 0, 4};   // channels in the file
  constexpr std::array<std::uint64_t, 7> decoded{1, 0, 3, 4, 2, 0, 4};  // a palette's may be RGBA
  if (kind >= stored.size() || stored[kind] == 0 || depth == 0 || depth > 16) {
    throw Refused("its PNG header makes no sense");
  }
  header.channels = decoded[kind];
  header.channel_bytes = depth == 16 ? 2 : 1;
  // Two bits of DEFLATE stand for at most 258 bytes, of all rows and their filter bytes.
  constexpr std::uint64_t best_ratio = 4 * 258;
  const std::uint64_t row = 1 + up(header.width * stored[kind] * depth, 8);
  header.least_file_bytes = header.height * (row / best_ratio);
  return header;
}

namespace {

/// Whether the file has an end of image after `offset`, where a segment or a scan's data begins.
/// libjpeg fills what is missing with grey and only warns, which OpenImageIO does not pass on.
bool has_jpeg_end(const PictureFile& file, std::uint64_t offset) {
  constexpr std::size_t rest_of_segment = 3;  // what it is, and its length
  std::array<unsigned char, 1 << 14> chunk{};
  while (const std::size_t count = file.read(offset, chunk.data(), chunk.size())) {
    // A marker too near the chunk's end waits for the next chunk; beyond the file's are zeros.
    std::fill(chunk.begin() + static_cast<std::ptrdiff_t>(count), chunk.end(), std::uint8_t{0});
    const bool is_last = count < chunk.size() - rest_of_segment;
    const std::size_t end = is_last ? count : chunk.size() - rest_of_segment;
    std::size_t at = 0;
    while (at < end) {
      if (chunk[at] != 0xff) {
        const auto* const mark = std::find(chunk.data() + at, chunk.data() + end, 0xff);
        at = static_cast<std::size_t>(mark - chunk.data());
        continue;
      }
      const unsigned kind = chunk[at + 1];
      if (kind == 0xd9) {
        return true;
      }
      const bool stands_alone = kind == 0 || kind == 1 || (kind >= 0xd0 && kind <= 0xd8);
      at += kind == 0xff ? 1 : stands_alone ? 2 : 2 + (chunk[at + 2] * 256u + chunk[at + 3]);
    }
    offset += at;
  }
  return false;
}

}  // namespace

PictureHeader parse_jpeg(const PictureFile& file) {
  PictureHeader header{"JPEG", "jpeg"};
  constexpr int most_segments = 10'000;
  Cursor at(file, 2, std::endian::big);
  for (int i = 0; i < most_segments; ++i) {
    if (at.u8() != 0xff) {
      throw Refused("its JPEG header makes no sense");
    }
    std::uint8_t marker = at.u8();
    for (int fill = 0; marker == 0xff && fill < most_segments; ++fill) {
      marker = at.u8();
    }
    if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) {
      continue;  // markers without a segment
    }
    const std::uint64_t segment = at.offset;
    const std::uint64_t length = at.u16();
    const bool is_frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame) {
      header.channel_bytes = at.u8() > 8 ? 2 : 1;
      header.height = at.u16();
      header.width = at.u16();
      header.channels = at.u8();
      if (marker <= 0xc2) {  // Huffman-coded: one bit or more for a block of 8 x 8
        header.least_file_bytes = header.width * header.height / 64 / 8;
      }
      if (!has_jpeg_end(file, segment + length)) {
        throw Refused("it is cut short: its JPEG data have no end");
      }
      return header;
    }
    if (length < 2 || marker == 0xd9 || marker == 0xda) {
      break;  // the picture begins, or ends, before its size is known
    }
    at.offset += length - 2;
  }
  throw Refused("its JPEG header makes no sense");
}

PictureHeader parse_bmp(const PictureFile& file) {
  PictureHeader header{"BMP", "bmp"};
  Cursor at(file, 10, std::endian::little);
  const std::uint64_t pixels_at = at.u32();
  const std::uint32_t size = at.u32();
  const bool is_os2 = size == 12;
  std::uint64_t bits = 0;
  std::uint32_t compression = 0;
  std::uint32_t colours = 0;
  if (is_os2) {
    header.width = at.u16();
    header.height = at.u16();
    at.u16();
    bits = at.u16();
  } else if (size >= 40 && size <= 124) {
    header.width = magnitude(at.i32());
    header.height = magnitude(at.i32());
    at.u16();
    bits = at.u16();
    compression = at.u32();
    at.offset = 46;
    colours = at.u32();
  }
  constexpr std::array<std::uint64_t, 6> depths{1, 4, 8, 16, 24, 32};
  if (std::ranges::find(depths, bits) == depths.end() || colours > 256) {
    throw Refused("its BMP header makes no sense");
  }
  constexpr std::uint32_t by_masks = 3;
  if (compression != 0 && compression != by_masks) {
    throw Refused("it is a compressed BMP, which is not read; save it as PNG");
  }
  header.channels = bits == 32 ? 4 : 3;
  header.least_file_bytes = pixels_at + header.height * (up(header.width * bits, 32) * 4);
  return header;
}

namespace {

struct TgaHeader {
  std::uint8_t id_length, palette, kind;
  std::uint16_t palette_length;
  std::uint8_t palette_bits;
  std::uint16_t width, height;
  std::uint8_t bits, descriptor;
};

TgaHeader read_tga(const PictureFile& file) {
  Cursor at(file, 0, std::endian::little);
  TgaHeader h{};
  h.id_length = at.u8();
  h.palette = at.u8();
  h.kind = at.u8();
  at.u16();
  h.palette_length = at.u16();
  h.palette_bits = at.u8();
  at.u32();
  h.width = at.u16();
  h.height = at.u16();
  h.bits = at.u8();
  h.descriptor = at.u8();
  return h;
}

constexpr std::string_view tga_footer{"TRUEVISION-XFILE.\0", 18};
constexpr std::uint64_t tga_footer_bytes = 26;  // two offsets, then the text

bool has_tga_footer(const PictureFile& file) {
  std::array<char, tga_footer.size()> end{};
  return file.size() > 18 + tga_footer_bytes &&
         file.read(file.size() - end.size(), end.data(), end.size()) == end.size() &&
         std::string_view(end.data(), end.size()) == tga_footer;
}

bool makes_sense(const TgaHeader& h) {
  const auto kind = h.kind & 7;
  const bool known = (h.kind & ~8) == kind && kind >= 1 && kind <= 3;
  const auto is_depth = [](std::uint8_t b) { return b == 15 || b == 16 || b == 24 || b == 32; };
  const bool depth = kind == 2 ? is_depth(h.bits) : h.bits == 8 || (h.bits == 16 && kind == 3);
  const bool palette = kind == 1
                           ? h.palette == 1 && h.palette_length > 0 && is_depth(h.palette_bits)
                           : h.palette <= 1;
  return known && depth && palette && (h.descriptor & 0xc0) == 0;
}

}  // namespace

bool looks_like_tga(const PictureFile& file) {
  std::string extension = file.path().extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return file.size() >= 18 && (extension == ".tga" || has_tga_footer(file)) &&
         makes_sense(read_tga(file));
}

PictureHeader parse_tga(const PictureFile& file) {
  const TgaHeader h = read_tga(file);
  PictureHeader header{"TGA", "targa"};
  header.width = h.width;
  header.height = h.height;
  header.channels = 4;  // at most
  const std::uint64_t palette = h.palette * h.palette_length * up(h.palette_bits, 8);
  const std::uint64_t pixel = up(h.bits, 8);
  const std::uint64_t pixels = header.width * header.height;
  const bool runs = (h.kind & 8) != 0;  // a run of 128 pixels takes a byte and a pixel
  header.least_file_bytes =
      18 + h.id_length + palette + (runs ? up(pixels, 128) * (1 + pixel) : pixels * pixel);
  header.readable_bytes = has_tga_footer(file) ? file.size() - tga_footer_bytes : file.size();
  return header;
}

PictureHeader parse_hdr(const PictureFile& file) {
  Cursor at(file, 0, std::endian::little);
  constexpr int most_lines = 200;
  int lines = 0;
  while (!at.text_until('\n', 1000).empty()) {
    if (++lines == most_lines) {
      throw Refused("its HDR header makes no sense");
    }
  }
  const std::string size = at.text_until('\n', 100);  // "-Y 512 +X 1024", or otherwise turned
  PictureHeader header{"HDR", "hdr"};
  header.channels = 3;
  header.channel_bytes = 4;
  std::array<std::uint64_t, 2> sides{};
  const char* p = size.data();
  const char* end = p + size.size();
  for (std::uint64_t& side : sides) {
    while (p != end && (*p < '0' || *p > '9')) {
      ++p;
    }
    p = std::from_chars(p, end, side).ptr;
  }
  header.height = sides[0];
  header.width = sides[1];
  return header;
}

}  // namespace rt::io
