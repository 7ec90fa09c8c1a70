#pragma once
#include <memory>
#include <variant>

#include "rt/scene/noise_texture.h"

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

/// What may drive a material. To add one: a struct, its value in render/surface_texture.cpp, and an
/// entry here.
using Texture = std::variant<Checker, ImageTexture, NoiseTexture>;

/// The checker's mean over the box of `width` about a point of model space; the colour there where
/// the width is 0. Cells count correctly at any finite coordinate. A point that lies on a wall
/// between cells, as far as rounding can tell, belongs to the upper cell: faces do not speckle.
///
/// A footprint is a parallelogram, the box holds it: exact for one along the axes, too smooth for
/// others. The worst is one that is long and lies along the diagonal of the cells, where the
/// checker is constant and the box gives grey: an error of up to half the contrast as long as the
/// footprint is narrower than a cell.
Rgb colour(const Checker& checker, const Vec3& p_model, const Vec3& width = Vec3(0.0));

/// Rec.709 luminance: what a colour stands for where one number is wanted.
inline double grey(const Rgb& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

}  // namespace rt
