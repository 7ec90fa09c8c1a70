#pragma once
#include <memory>
#include <string>

#include "pyramid.h"
#include "table.h"

namespace rt::io {

struct DecodedTexture {
  std::shared_ptr<const Pyramid> pyramid;
  bool is_encoded = false;  ///< 8 or 16 bits a channel: taken for sRGB
};

/// Decodes a picture into a pyramid, a few rows at a time. Throws std::runtime_error.
DecodedTexture decode_texture(const TextureRequest& request);

}  // namespace rt::io
