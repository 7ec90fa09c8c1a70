#pragma once
/// Textures for tests: pictures given by a formula.
#include <functional>

#include "rt/scene/texture_image.h"
#include "scenes.h"

namespace rt::test {

/// A picture whose colour at (u, v) is a formula; it does not filter, but remembers nothing either.
class FormulaImage : public TextureImage {
 public:
  using Formula = std::function<Rgb(const Vec2&)>;
  explicit FormulaImage(Formula formula) : formula_(std::move(formula)) {}

  const std::filesystem::path& file() const override { return file_; }
  Rgb value(const TextureFootprint& at, Wrap, bool) const override { return formula_(at.uv); }
  /// Derivatives by central differences: exact to 1e-9 for smooth formulas of unit size.
  TextureSample sample(const TextureFootprint& at, Wrap, bool) const override {
    const double h = 1e-5;
    return {formula_(at.uv),
            (formula_(at.uv + Vec2(h, 0)) - formula_(at.uv - Vec2(h, 0))) / (2 * h),
            (formula_(at.uv + Vec2(0, h)) - formula_(at.uv - Vec2(0, h))) / (2 * h)};
  }

 private:
  std::filesystem::path file_ = "formula";
  Formula formula_;
};

/// Shows what footprint it is asked for: |du/dx| + |du/dy|, the same of v.
class FootprintImage : public FormulaImage {
 public:
  FootprintImage() : FormulaImage([](const Vec2&) { return Rgb(0.0); }) {}
  Rgb value(const TextureFootprint& at, Wrap, bool) const override {
    return {std::abs(at.duv_dx.x) + std::abs(at.duv_dy.x),
            std::abs(at.duv_dx.y) + std::abs(at.duv_dy.y), 0.0};
  }
};

inline Texture formula(FormulaImage::Formula f, const Vec2& scale = Vec2(1.0)) {
  return ImageTexture{std::make_shared<const FormulaImage>(std::move(f)), scale, Wrap::repeat};
}

/// u, v as red and green.
inline Texture coordinates_picture() {
  return formula([](const Vec2& uv) { return Rgb(uv.x, uv.y, 0.0); });
}

/// Gives the instance added last a texture.
inline void paint(RenderJob& job, const Texture& texture, TextureSlot slot = TextureSlot::kd,
                  double strength = 1.0) {
  Instance last = job.instances.back();
  auto set =
      last.textures ? std::make_shared<TextureSet>(*last.textures) : std::make_shared<TextureSet>();
  (*set)[slot] = {std::make_shared<const Texture>(texture), strength};
  last.textures = set;
  job.instances.replace(job.instances.size() - 1, last);
}

}  // namespace rt::test
