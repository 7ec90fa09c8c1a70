/// TIFF and EXR: headers that are lists of named values.
#include <algorithm>

#include "texture_parse.h"

namespace rt::io {
namespace {

/// Which of TIFF's two forms: 32-bit offsets, or 64-bit (BigTIFF).
struct TiffForm {
  std::endian order;
  std::size_t count_bytes;   ///< of the number of entries
  std::size_t offset_bytes;  ///< of counts and values in an entry
};

/// The first value of an entry whose type, count and value field begin at the cursor.
std::uint64_t first_value(const TiffForm& form, Cursor at) {
  const std::uint16_t type = at.u16();
  const std::uint64_t count = at.number(form.offset_bytes);
  const std::size_t size = type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 1;
  if (count > form.offset_bytes / size) {  // it does not fit: an offset stands there
    at.offset = at.number(form.offset_bytes);
  }
  return at.number(size);
}

}  // namespace

PictureHeader parse_tiff(const PictureFile& file) {
  char mark[4] = {};
  Cursor(file, 0, std::endian::little).read(mark, 4);
  const bool is_big = mark[2] == '+' || mark[3] == '+';
  const TiffForm form{mark[0] == 'M' ? std::endian::big : std::endian::little,
                      is_big ? std::size_t{8} : 2, is_big ? std::size_t{8} : 4};
  Cursor at(file, is_big ? 8 : 4, form.order);
  at.offset = at.number(form.offset_bytes);
  const std::uint64_t entries = at.number(form.count_bytes);
  constexpr std::uint64_t most_entries = 4096;
  if (entries > most_entries) {
    throw Refused("its TIFF header makes no sense");
  }
  PictureHeader header{"TIFF", "tiff"};
  header.channels = 1;
  std::uint64_t bits = 1, tile_width = 0, tile_height = 0;
  for (std::uint64_t i = 0; i < entries; ++i) {
    const std::uint16_t tag = at.u16();
    std::uint64_t* const wanted = tag == 256   ? &header.width
                                  : tag == 257 ? &header.height
                                  : tag == 258 ? &bits
                                  : tag == 277 ? &header.channels
                                  : tag == 322 ? &tile_width
                                  : tag == 323 ? &tile_height
                                               : nullptr;
    if (wanted != nullptr) {
      *wanted = first_value(form, at);
    }
    at.offset += 2 + 2 * form.offset_bytes;
  }
  // A tile is decoded whole, however little of it the picture covers.
  constexpr std::uint64_t sensible_tile = 4096;
  if (header.channels > 1024 || bits > 64 || bits == 0 ||
      tile_width > std::max(2 * header.width, sensible_tile) ||
      tile_height > std::max(2 * header.height, sensible_tile)) {
    throw Refused("its TIFF header makes no sense");
  }
  if (bits <= 8 && header.channels == 1) {
    header.channels = 3;  // there may be a palette
  }
  header.channel_bytes = (bits + 7) / 8;
  return header;
}

namespace {

struct ExrPart {
  std::uint64_t width = 0, height = 0, channels = 0, channel_bytes = 0;
};

std::uint64_t extent(std::int64_t lo, std::int64_t hi) {
  return hi < lo ? 0 : static_cast<std::uint64_t>(hi - lo + 1);
}

void read_window(Cursor at, ExrPart& part) {
  const std::int32_t x0 = at.i32(), y0 = at.i32(), x1 = at.i32(), y1 = at.i32();
  part.width = std::max(part.width, extent(x0, x1));
  part.height = std::max(part.height, extent(y0, y1));
}

void read_channels(Cursor at, ExrPart& part) {
  constexpr std::uint64_t most_channels = 1024;
  while (!at.text_until('\0', 255).empty()) {
    const std::uint32_t type = at.u32();  // 0: 32-bit whole, 1: half, 2: float
    part.channel_bytes = std::max<std::uint64_t>(part.channel_bytes, type == 1 ? 2 : 4);
    at.offset += 12;
    if (++part.channels > most_channels) {
      throw Refused("it has more channels than a texture needs");
    }
  }
}

/// One header, up to the empty name that ends it. False when that comes at once.
bool read_part(Cursor& at, ExrPart& part) {
  constexpr int most_attributes = 2000;
  constexpr std::uint32_t largest_tile = 4096;
  for (int i = 0; i < most_attributes; ++i) {
    const std::string name = at.text_until('\0', 255);
    if (name.empty()) {
      return i > 0;
    }
    at.text_until('\0', 255);  // its type
    const std::uint32_t size = at.u32();
    if (name == "dataWindow" || name == "displayWindow") {
      read_window(at, part);
    } else if (name == "channels") {
      read_channels(at, part);
    } else if (Cursor tile = at;
               name == "tiles" && (tile.u32() > largest_tile || tile.u32() > largest_tile)) {
      throw Refused("its tiles are larger than a texture's may be");
    }
    at.offset += size;
  }
  throw Refused("its EXR header makes no sense");
}

}  // namespace

PictureHeader parse_exr(const PictureFile& file) {
  Cursor at(file, 4, std::endian::little);
  const std::uint32_t version = at.u32();
  constexpr std::uint32_t deep = 0x800, several_parts = 0x1000;
  if ((version & 0xff) != 2 || (version & deep) != 0) {
    throw Refused("it is an EXR file of a kind that textures cannot be (deep, or not version 2)");
  }
  PictureHeader header{"EXR", "openexr"};
  constexpr int most_parts = 64;
  for (int i = 0; i < ((version & several_parts) != 0 ? most_parts : 1); ++i) {
    ExrPart part;
    if (!read_part(at, part)) {
      break;
    }
    header.width = std::max(header.width, part.width);
    header.height = std::max(header.height, part.height);
    header.channels = std::max(header.channels, part.channels);
    header.channel_bytes = std::max(header.channel_bytes, part.channel_bytes);
  }
  // The smallest file begins with a table of 8 bytes for each block of up to 256 lines.
  header.least_file_bytes = header.height / 256 * 8;
  return header;
}

}  // namespace rt::io
