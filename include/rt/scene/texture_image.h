#pragma once
/// Pictures as textures read them. What decodes and filters them is behind this interface, so that
/// neither the scene nor the renderer knows of it.
#include <filesystem>

#include "rt/math/vec.h"

namespace rt {

/// Where a texture is looked up, and over what area: coordinates with v up, and how far they move
/// from one sample to the next.
struct TextureFootprint {
  Vec2 uv;
  Vec2 duv_dx{0.0};
  Vec2 duv_dy{0.0};
};

/// A colour that a texture gives, linear Rec.709, and its change by u and v of the footprint.
struct TextureSample {
  Rgb value{0.0};
  Rgb d_du{0.0};
  Rgb d_dv{0.0};
};

enum class Wrap;

/// A picture that has been found fit to be read; its pixels are decoded when first looked up.
/// Lookups may come from any number of threads at once.
class TextureImage {
 public:
  virtual ~TextureImage() = default;

  /// The file, for messages.
  virtual const std::filesystem::path& file() const = 0;

  /// Filtered over the footprint. Grey pictures give three equal channels. Images that hold 8 or
  /// 16 bits a channel are taken for sRGB and linearised, unless `raw` (for bumps and normals).
  virtual Rgb value(const TextureFootprint& footprint, Wrap wrap, bool raw) const = 0;

  /// The same, with derivatives.
  virtual TextureSample sample(const TextureFootprint& footprint, Wrap wrap, bool raw) const = 0;
};

}  // namespace rt
