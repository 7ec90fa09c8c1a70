#pragma once
#include <memory>
#include <vector>

#include "rt/math/octaves.h"

namespace rt {

/// A colour at a value of the pattern.
struct RampStop {
  double at;
  Rgb colour;
};

/// A pattern of noise in model space, coloured by a ramp: straight between stops, constant beyond
/// the first and the last.
struct NoiseTexture {
  NoiseKind kind = NoiseKind::fbm;
  std::vector<Octave> octaves{{1.0, 1.0}};
  std::vector<RampStop> ramp{{0.0, Rgb(0.0)}, {1.0, Rgb(1.0)}};  ///< not empty; `at` does not fall
  std::shared_ptr<const Noise> noise;                            ///< never null
};

/// A grey value and how it changes over model space.
struct HeightSample {
  double value;
  Vec3 gradient;
};

/// The colour at a point of model space, over a footprint: `dp_dx` and `dp_dy` lead to the samples
/// next to it. What the footprint cannot carry is replaced by its mean, through the ramp: the ramp
/// is averaged over the values that the lost octaves would have spread to. A footprint longer than
/// wide is taken in up to `noise_probes` parts, else grazing views would blur across as well.
Rgb colour(const NoiseTexture& texture, const Vec3& p_model, const Vec3& dp_dx, const Vec3& dp_dy);
inline constexpr int noise_probes = 4;

/// The grey value, band-limited likewise, and its analytic gradient.
HeightSample height(const NoiseTexture& texture, const Vec3& p_model, const Vec3& dp_dx,
                    const Vec3& dp_dy);

}  // namespace rt
