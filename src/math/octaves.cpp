#include "rt/math/octaves.h"

#include <algorithm>
#include <cmath>

#include "rt/math/warp.h"

namespace rt {
namespace {

/// A normalised sum of octaves: fbm in [-1, 1] or turbulence in [0, 1].
struct Sum {
  double value = 0.0;
  Vec3 gradient{0.0};
  double lost = 0.0;  ///< variance over space of what band limiting took away
};

/// Adds an octave of which the share `keep` stays, the rest at its mean. What is lost of an
/// amplitude is (1 - keep) of it.
template <bool folded>
void add(Sum& sum, const NoiseSample& n, double weight, double frequency, double keep) {
  const double mean = folded ? noise_mean_abs : 0.0;
  const double variance = folded ? noise_variance - mean * mean : noise_variance;
  const double value = folded ? std::abs(n.value) : n.value;
  const double sign = folded ? std::copysign(1.0, n.value) : 1.0;
  sum.value += weight * (mean + keep * (value - mean));
  sum.gradient += (weight * keep * frequency * sign) * n.gradient;
  sum.lost += weight * weight * (1.0 - keep * keep) * variance;
}

template <bool folded, bool with_gradient>
Sum summed(const Noise& noise, std::span<const Octave> octaves, const Vec3& p, double footprint) {
  double total = 0.0;
  for (const Octave& o : octaves) {
    total += std::abs(o.weight);
  }
  Sum sum;
  for (const Octave& o : octaves) {
    const double weight = (folded ? std::abs(o.weight) : o.weight) / total;
    const double keep = band_limit(o.frequency, footprint);
    NoiseSample n{0.0, Vec3(0.0)};
    if (keep > 0.0) {  // a faded octave costs nothing
      if constexpr (with_gradient) {
        n = noise.sample(o.frequency * p);
      } else {
        n.value = noise.value(o.frequency * p);
      }
    }
    add<folded>(sum, n, weight, o.frequency, keep);
  }
  return sum;
}

/// 1/2 + 1/2 sin(2 pi phase), with a phase that is `carrier` plus a displacement by `sum`.
PatternSample stripes(double carrier, const Vec3& carrier_gradient, double displacement,
                      const Sum& sum, double keep) {
  if (!std::isfinite(carrier)) {
    return {0.5, Vec3(0.0)};  // beyond 2^1023 periods: the mean
  }
  const double phase = carrier + displacement * sum.value;
  const double turn = 2.0 * pi * (phase - std::floor(phase));  // digits of large phases are kept
  const double deviation = 2.0 * pi * displacement;
  const double amplitude = 0.5 * keep * std::exp(-0.5 * deviation * deviation * sum.lost);
  const Vec3 slope = carrier_gradient + displacement * sum.gradient;
  return {0.5 + amplitude * std::sin(turn), 2.0 * pi * amplitude * std::cos(turn) * slope};
}

template <bool with_gradient>
PatternSample evaluate(const Noise& noise, NoiseKind kind, std::span<const Octave> octaves,
                       const Vec3& p, double footprint) {
  const bool folded = kind == NoiseKind::turbulence || kind == NoiseKind::marble;
  const bool any =
      std::any_of(octaves.begin(), octaves.end(), [](const Octave& o) { return o.weight != 0.0; });
  if (!any || !all_finite(p)) {
    return {kind == NoiseKind::turbulence ? noise_mean_abs : 0.5, Vec3(0.0)};
  }
  const Sum sum = folded ? summed<true, with_gradient>(noise, octaves, p, footprint)
                         : summed<false, with_gradient>(noise, octaves, p, footprint);
  const double first = octaves.front().frequency;
  switch (kind) {
    case NoiseKind::fbm:
      return {0.5 + 0.5 * sum.value, 0.5 * sum.gradient};
    case NoiseKind::turbulence:
      return {sum.value, sum.gradient};
    case NoiseKind::marble:
      return stripes(first * p.x, Vec3(first, 0, 0), marble_displacement, sum,
                     band_limit(first, footprint));
    case NoiseKind::wood:
      break;
  }
  const double radius = std::hypot(p.x, p.z);
  const Vec3 outward = radius > 0.0 ? Vec3(p.x / radius, 0, p.z / radius) : Vec3(0.0);
  return stripes(first * radius, first * outward, wood_displacement, sum,
                 band_limit(first, footprint));
}

}  // namespace

double band_limit(double frequency, double footprint) {
  const double t = std::clamp(2.0 - 2.0 * std::abs(frequency) * footprint, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

PatternSample pattern(const Noise& noise, NoiseKind kind, std::span<const Octave> octaves,
                      const Vec3& p, double footprint) {
  return evaluate<true>(noise, kind, octaves, p, footprint);
}

double pattern_value(const Noise& noise, NoiseKind kind, std::span<const Octave> octaves,
                     const Vec3& p, double footprint) {
  return evaluate<false>(noise, kind, octaves, p, footprint).value;
}

}  // namespace rt
