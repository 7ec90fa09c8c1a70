/// rt_oiio.so: pictures in and out, and the table of what the module offers. Textures:
/// textures.cpp.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>

#include "reason.h"
#include "table.h"
#include "textures.h"

namespace rt::io {
namespace {

// Four times the largest picture a sensible wall poster needs; a small file that claims more is
// broken or hostile, and its memory is never asked for.
constexpr std::int64_t max_pixels = std::int64_t{1} << 28;

OIIO::ImageSpec spec_of(const EncodeRequest& request) {
  OIIO::ImageSpec spec(request.width, request.height, 3,
                       request.is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  const std::string format = request.format;
  if (format == "openexr") {
    spec.attribute("compression", "zip");
  } else if (format == "jpeg") {
    spec.attribute("Compression", "jpeg:95");
    // Synthetic pictures have coloured edges one pixel wide: keep the chroma at full resolution.
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  if (request.is_srgb) {
    spec.attribute("oiio:ColorSpace", "sRGB");
  }
  if (format == "png" || format == "openexr") {
    for (const auto& [name, value] : *request.metadata) {
      spec.attribute(name, value);
    }
  }
  // OpenImageIO adds the present time to EXR where no DateTime is given, and drops one that is no
  // text: equal inputs give equal bytes.
  spec.attribute("DateTime", 0);
  return spec;
}

std::string encode_or_throw(const EncodeRequest& request, std::vector<unsigned char>& file) {
  auto output = OIIO::ImageOutput::create(request.format);
  if (!output) {
    return reason_of(OIIO::geterror());
  }
  OIIO::Filesystem::IOVecOutput memory(file);
  output->set_ioproxy(&memory);
  const auto type = request.is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  const std::string name = std::string("picture.") + request.format;
  if (!output->open(name, spec_of(request)) || !output->write_image(type, request.pixels) ||
      !output->close()) {
    return reason_of(output->geterror());
  }
  return "";
}

std::string decode_or_throw(const char* format, const std::string& path, DecodedImage& image) {
  auto input = OIIO::ImageInput::create(format);
  if (!input) {
    return reason_of(OIIO::geterror());
  }
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);  // no multiplication by alpha: stored values
  OIIO::ImageSpec spec;
  if (!input->open(path, spec, hints)) {
    return reason_of(input->geterror());
  }
  const std::int64_t pixels = std::int64_t{spec.width} * spec.height;
  if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels <= 0 ||
      pixels > max_pixels) {
    return "its header claims " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
           " pixels of " + std::to_string(spec.nchannels) + " channels, which is beyond reading";
  }
  const int channels = std::min(spec.nchannels, 3);
  std::vector<float> stored(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, stored.data())) {
    return reason_of(input->geterror());
  }
  image.width = spec.width;
  image.height = spec.height;
  if (channels == 3) {
    image.pixels = std::move(stored);
    return "";
  }
  image.pixels.reserve(static_cast<std::size_t>(pixels) * 3);  // grey, with alpha or without
  for (std::size_t i = 0; i < stored.size(); i += static_cast<std::size_t>(channels)) {
    image.pixels.insert(image.pixels.end(), 3, stored[i]);
  }
  return "";
}

std::string encode(const EncodeRequest& request, std::vector<unsigned char>& file) {
  return guarded([&] { return encode_or_throw(request, file); });
}

std::string decode(const char* format, const std::string& path, DecodedImage& image) {
  return guarded([&] { return decode_or_throw(format, path, image); });
}

}  // namespace
}  // namespace rt::io

extern "C" {
__attribute__((visibility("default"))) extern const rt::io::OiioTable rt_oiio_table;
const rt::io::OiioTable rt_oiio_table{rt::io::encode,        rt::io::decode,
                                      rt::io::make_texture,  rt::io::drop_texture,
                                      rt::io::look_up,       rt::io::set_texture_memory,
                                      rt::io::texture_counts};
}
