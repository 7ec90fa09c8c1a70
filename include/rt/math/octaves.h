#pragma once
/// Patterns made of octaves of noise. Source: Perlin, "An image synthesizer", SIGGRAPH 1985; band
/// limiting as in Ebert et al., "Texturing and Modeling", 3rd ed., ch. 2.
#include <span>

#include "rt/math/noise.h"
#include "rt/math/vec.h"

namespace rt {

struct Octave {
  double frequency;  ///< lattice cells per unit of length
  double weight;     ///< only ratios matter: a pattern divides by the sum of magnitudes
};

enum class NoiseKind {
  fbm,         ///< 1/2 + 1/2 sum of weight noise
  turbulence,  ///< sum of |weight noise|
  marble,      ///< sine stripes across x, displaced by turbulence
  wood,        ///< sine rings about the y axis, displaced by fbm
};

/// How much of a frequency stays at a footprint (the width on the surface that one sample stands
/// for): 1 up to half a cell a footprint, 0 from one cell on, smooth between. Noise has most of its
/// energy near 0.6 cycles a cell; at half a cell a box filter of the footprint keeps 87% of its
/// amplitude, and samples one cell apart can no longer carry it.
double band_limit(double frequency, double footprint);

struct PatternSample {
  double value;   ///< in [0, 1]
  Vec3 gradient;  ///< by the point; what fades out has none
};

/// The pattern at p. Stripes of marble and rings of wood have the period 1 / frequency of the first
/// octave, and are displaced by up to marble_displacement and wood_displacement periods.
///
/// What the footprint cannot carry is replaced by its mean over space: 0 for an octave of fbm, but
/// noise_mean_abs for one of turbulence, so that distance neither darkens nor brightens a surface.
/// For marble and wood the lost displacement also blurs the stripes, by the mean of cos of a normal
/// deviate, exp(-variance/2). With no octaves, and where p is not finite, the mean.
PatternSample pattern(const Noise& noise, NoiseKind kind, std::span<const Octave> octaves,
                      const Vec3& p, double footprint = 0.0);

/// The value alone, at about half the cost.
double pattern_value(const Noise& noise, NoiseKind kind, std::span<const Octave> octaves,
                     const Vec3& p, double footprint = 0.0);

inline constexpr double marble_displacement = 2.0;
inline constexpr double wood_displacement = 0.5;

}  // namespace rt
