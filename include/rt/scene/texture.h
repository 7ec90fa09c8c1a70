#pragma once
#include <memory>
#include <variant>

#include "rt/math/vec.h"

namespace rt {

class TextureImage;

/// A solid checker in model space: the cell of p is floor(p / size), its colour `even` where the
/// sum of the cell's coordinates is even, else `odd`.
struct Checker {
  Rgb even{1.0};
  Rgb odd{0.0};
  double size = 1.0;  ///< edge of a cell, > 0
};

/// What an image texture gives beyond [0,1]^2.
enum class Wrap { repeat, clamp, mirror, black };

/// A picture laid on a surface by its coordinates.
struct ImageTexture {
  std::shared_ptr<const TextureImage> image;
  Vec2 scale{1.0};  ///< the picture's coordinates are the surface's times this
  Wrap wrap = Wrap::repeat;
};

/// What may stand for a material's kd. To add one: a struct, its colour(), and an entry here.
using Texture = std::variant<Checker, ImageTexture>;

/// The colour at a point of model space. Cells count correctly at any finite coordinate.
Rgb colour(const Checker& checker, const Vec3& p_model);
/// Mid-grey: a picture has its place on a surface, not in space.
Rgb colour(const ImageTexture& texture, const Vec3& p_model);

}  // namespace rt
