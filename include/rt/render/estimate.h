#pragma once
/// The mean of a pixel's samples, and how far it may be from the truth.
///
/// The samples are a scrambled net: their own variance says little, since the mean of n of them
/// errs by far less than sigma / sqrt(n). Two things are known instead.
///  - The *quarters*: each aligned quarter of a net is a net of its own, scrambled differently. The
///    four means scatter as the error of n/4 samples does; the whole errs less by a known rate.
///  - The *contrast*: the variance of the first samples of the 3x3 pixels about, which also sees
///    what the pixel's own few missed. Each lies in a quadrant of its pixel; those in the twelve
///    quadrants that touch the pixel count like its own, those beyond an eighth of that: what lies
///    there only seldom reaches the pixel.
/// Both are extrapolated to n samples as n^-p. An edge in the pixel's two dimensions alone has
/// p = 3/2; the more dimensions and detail, the nearer to 1, the rate of independent samples (see
/// tests/convergence). p is taken from the samples: how much less their mean varies than they do.
/// Four quarters are few: every doubling takes the mean of three estimates, the one before, the
/// quarters', and one from the variance of all samples, p midway to that of an edge.
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "rt/math/vec.h"
#include "rt/math/wide.h"
#include "rt/scene/options.h"

namespace rt {

struct PixelEstimate {
  std::array<Rgb, 4> quarters{};  ///< sums over quarters of the samples, once there are 4
  Rgb squares{0.0};               ///< sum of squares over the samples
  Rgb variance{0.0};              ///< of the mean, as estimated
  float error = 0.0F;             ///< in displayed units
  std::uint32_t count = 0;
  std::uint32_t pilots = 0;  ///< of them, taken before anything was estimated
  std::uint32_t bad = 0;     ///< of them, not finite

  Rgb mean() const;
};

/// Counts the next samples in, those that are none as bad; there are to be `count` of them: from 4 on
/// twice as many as before.
void count_in(PixelEstimate& e, std::span<const std::optional<Rgb>> values, std::uint32_t count);

/// Of a pixel's first samples: the variance of their mean, and the error that is claimed for it. The
/// contrast: the variance of one sample.
Rgb variance_of_pilots(const Rgb& contrast, std::uint32_t pilots);
Wide estimated_error(const Wide3& mean, const Wide3& contrast, std::uint32_t pilots,
                     Encoding encoding);

/// Estimates anew once a pixel's samples have been doubled.
void estimate_doubled(PixelEstimate& e, Encoding encoding);

/// The same for a pixel that took more pilots than others, for the sake of something thin: their own
/// scatter is evidence, too.
void estimate_thin(PixelEstimate& e, const Rgb& contrast, Encoding encoding);

/// The variance of the mean of `e.count` samples, from the scatter of its quarters, where it falls
/// as n^-exponent.
Rgb variance_of_quarters(const PixelEstimate& e, double exponent);

/// A standard deviation `s` about `mean`, linear, in displayed units: the largest over channels.
/// Half of what the screen shows between mean - s and mean + s, so that what is clipped there does
/// not count.
double displayed_error(const Rgb& mean, const Rgb& s, Encoding encoding);
/// The same for several.
Wide displayed_error(const Wide3& mean, const Wide3& s, Encoding encoding);

}  // namespace rt
