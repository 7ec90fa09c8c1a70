#include "rt/io/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "oiio_loader.h"
#include "rt/io/encoding.h"
#include "rt/io/whole_file.h"
#include "rt/scene/error.h"

namespace rt::io {
namespace {

struct Format {
  std::string_view extension;
  const char* name;        ///< OpenImageIO's
  std::string_view magic;  ///< how its files begin; empty: any way
  int largest;             ///< width or height, by the format's header
};

using namespace std::string_view_literals;

constexpr int any_side = 1 << 20;  // beyond any picture here; PNG's 1000000 is libpng's limit
constexpr std::array formats{
    Format{".png", "png", "\x89PNG\r\n\x1a\n"sv, 1000000},
    Format{".bmp", "bmp", "BM"sv, any_side},
    Format{".exr", "openexr", "\x76\x2f\x31\x01"sv, any_side},
    Format{".jpg", "jpeg", "\xff\xd8\xff"sv, 65500},
    Format{".jpeg", "jpeg", "\xff\xd8\xff"sv, 65500},
    Format{".tga", "targa", ""sv, 65535},
};

const Format* format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* found = std::find_if(formats.begin(), formats.end(),
                                   [&](const Format& f) { return f.extension == extension; });
  return found == formats.end() ? nullptr : found;
}

const Format& output_format(const std::filesystem::path& path) {
  const Format* format = format_of(path);
  if (format == nullptr) {
    throw FileError(fmt::format(
        "cannot write {}: its name must end in .png, .bmp, .exr, .tga, .jpg or .jpeg, not in {}",
        path.string(), path.has_extension() ? path.extension().string() : "nothing"));
  }
  return *format;
}

void check_size(const std::filesystem::path& path, const Format& format, int width, int height) {
  if (std::max(width, height) > format.largest) {
    throw FileError(fmt::format(
        "cannot write {}: {} x {} pixels, but this format holds at most {} a side; write .exr",
        path.string(), width, height, format.largest));
  }
}

/// The reader for what the file holds, whatever its name says. Throws FileError.
const char* reader_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 8> start{};
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored) || !file ||
                               (file.read(start.data(), start.size()), file.bad())) {
    throw FileError(fmt::format("cannot read {}: {}", path.string(),
                                std::generic_category().message(errno ? errno : EISDIR)));
  }
  const std::string_view seen(start.data(), static_cast<std::size_t>(file.gcount()));
  for (const Format& format : formats) {
    if (!format.magic.empty() && seen.starts_with(format.magic)) {
      return format.name;
    }
  }
  const Format* named = format_of(path);
  if (named != nullptr && named->magic.empty()) {
    return named->name;
  }
  throw FileError(
      fmt::format("cannot read {}: it is no PNG, BMP, EXR, JPEG or TGA picture", path.string()));
}

/// Into memory first: OpenImageIO's writers do not all notice a disk that is full.
std::vector<unsigned char> encoded(const std::string& what, const Format& format,
                                   const Image& image, Encoding encoding,
                                   const std::map<std::string, std::string>& metadata) {
  const auto values = static_cast<std::size_t>(std::max(image.width, 0)) *
                      static_cast<std::size_t>(std::max(image.height, 0)) * 3;
  if (values == 0 || image.pixels.size() != values) {
    throw std::invalid_argument("an image without pixels, or of another size");
  }
  check_size(what, format, image.width, image.height);
  EncodeRequest request{.format = format.name,
                        .width = image.width,
                        .height = image.height,
                        .pixels = image.pixels.data(),
                        .is_float = format.extension == ".exr",
                        .is_srgb = false,
                        .metadata = &metadata};
  std::vector<std::uint8_t> codes;
  if (!request.is_float) {
    codes = encode8(image, encoding);
    request.pixels = codes.data();
    request.is_srgb = encoding == Encoding::srgb;
  }
  std::vector<unsigned char> file;
  const std::string reason = oiio().encode(request, file);
  if (!reason.empty()) {
    throw FileError(fmt::format("cannot write {}: {}; try another format", what, reason));
  }
  return file;
}

}  // namespace

void preload() { begin_loading_oiio(); }
void end_preload() { end_loading_oiio(); }

void check_output(const std::filesystem::path& path, int width, int height) {
  check_size(path, output_format(path), width, height);
  check_place(path);
}

void write_image(const std::filesystem::path& path, const Image& image, Encoding encoding,
                 const std::map<std::string, std::string>& metadata) {
  write_whole_file(path, encoded(path.string(), output_format(path), image, encoding, metadata));
}

std::vector<unsigned char> encode_png(const Image& image, Encoding encoding) {
  return encoded("a PNG picture", formats.front(), image, encoding, {});
}

Image read_image(const std::filesystem::path& path) {
  const char* format = reader_of(path);
  DecodedImage decoded;
  const std::string reason = oiio().decode(format, path.string(), decoded);
  if (!reason.empty()) {
    throw FileError(fmt::format("cannot read {}: {}", path.string(), reason));
  }
  return {decoded.width, decoded.height, std::move(decoded.pixels)};
}

}  // namespace rt::io
