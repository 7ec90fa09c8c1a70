#include "rt/scene/noise_texture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rt/scene/texture.h"

namespace rt {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A footprint as so many equal parts along its longer axis, each about as wide as long.
struct Parts {
  int count = 1;
  Vec3 along{0.0};     ///< the whole length
  double width = 0.0;  ///< of a part
  bool fades = false;  ///< some octave is lost to it
};

/// The axes are those of the ellipse { a cos t + b sin t }, from the eigenvalues of the matrix of
/// products of a and b.
Parts parts_of(const Vec3& a, const Vec3& b, double highest_frequency) {
  const double e = glm::dot(a, a);
  const double f = glm::dot(a, b);
  const double g = glm::dot(b, b);
  const double major_squared = 0.5 * (e + g) + std::hypot(0.5 * (e - g), f);
  if (!(major_squared > 0.0)) {
    return {};
  }
  const double major = std::sqrt(major_squared);
  if (!std::isfinite(major)) {
    return {1, Vec3(0.0), infinity, true};
  }
  if (band_limit(highest_frequency, major) == 1.0) {
    return {1, Vec3(0.0), major};  // nothing would fade
  }
  const double minor = std::sqrt(std::max(0.0, e * g - f * f) / major_squared);
  const double ratio = std::ceil(std::min(major / std::max(minor, 1e-300), 1.0 * noise_probes));
  const double turn = 0.5 * std::atan2(2.0 * f, e - g);
  return {static_cast<int>(ratio), std::cos(turn) * a + std::sin(turn) * b,
          std::max(minor, major / ratio), true};
}

double highest_frequency(const NoiseTexture& texture) {
  double highest = 0.0;
  for (const Octave& o : texture.octaves) {
    highest = std::max(highest, std::abs(o.frequency));
  }
  return highest;
}

/// Variance over space of what band limiting takes from the pattern's value.
double lost_variance(const NoiseTexture& texture, double width) {
  const bool folded = texture.kind == NoiseKind::turbulence || texture.kind == NoiseKind::marble;
  const double of_noise = noise_variance - (folded ? noise_mean_abs * noise_mean_abs : 0.0);
  double total = 0.0;
  double lost = 0.0;
  for (const Octave& o : texture.octaves) {
    const double keep = band_limit(o.frequency, width);
    total += std::abs(o.weight);
    lost += o.weight * o.weight * (1.0 - keep * keep) * of_noise;
  }
  if (!(total > 0.0)) {
    return 0.0;
  }
  lost /= total * total;
  if (texture.kind == NoiseKind::fbm) {
    return 0.25 * lost;
  }
  if (texture.kind == NoiseKind::turbulence) {
    return lost;
  }
  // Stripes: a sine of amplitude 1/2 has variance 1/8, the blurred one pattern() gives less.
  const double turns = texture.kind == NoiseKind::marble ? marble_displacement : wood_displacement;
  const double deviation = 2.0 * std::numbers::pi * turns;
  const double kept = band_limit(texture.octaves.front().frequency, width) *
                      std::exp(-0.5 * deviation * deviation * lost);
  return 0.125 * (1.0 - kept * kept);
}

Rgb ramp_at(const std::vector<RampStop>& ramp, double t) {
  const auto next = std::ranges::upper_bound(ramp, t, {}, &RampStop::at);
  if (next == ramp.begin()) {
    return next->colour;
  }
  const RampStop& before = *(next - 1);
  if (next == ramp.end()) {
    return before.colour;
  }
  return glm::mix(before.colour, next->colour, (t - before.at) / (next->at - before.at));
}

/// Mean of the ramp over [a, b]: exact, piece by piece, since pieces are straight.
Rgb ramp_mean(const std::vector<RampStop>& ramp, double a, double b) {
  if (!(b > a)) {
    return ramp_at(ramp, a);
  }
  Rgb sum(0.0);
  double from = a;
  for (std::size_t i = 0; i <= ramp.size() && from < b; ++i) {
    const double to = std::min(b, i < ramp.size() ? ramp[i].at : infinity);
    if (to > from) {
      sum += (to - from) * ramp_at(ramp, 0.5 * (from + to));
      from = to;
    }
  }
  return sum / (b - a);
}

double ramp_slope(const std::vector<RampStop>& ramp, double t) {
  const auto next = std::ranges::upper_bound(ramp, t, {}, &RampStop::at);
  if (next == ramp.begin() || next == ramp.end()) {
    return 0.0;
  }
  const RampStop& before = *(next - 1);
  return (grey(next->colour) - grey(before.colour)) / (next->at - before.at);
}

/// Half the width of the box that has the variance of what was lost.
double half_spread(const NoiseTexture& texture, const Parts& parts) {
  return parts.fades ? std::sqrt(3.0 * lost_variance(texture, parts.width)) : 0.0;
}

/// Calls visit(point) for the middle of every part.
template <class Visit>
void each_part(const Parts& parts, const Vec3& p, Visit visit) {
  for (int i = 0; i < parts.count; ++i) {
    visit(p + ((i + 0.5) / parts.count - 0.5) * parts.along);
  }
}

}  // namespace

Rgb colour(const NoiseTexture& texture, const Vec3& p_model, const Vec3& dp_dx, const Vec3& dp_dy) {
  const Parts parts = parts_of(dp_dx, dp_dy, highest_frequency(texture));
  const double half = half_spread(texture, parts);
  Rgb sum(0.0);
  each_part(parts, p_model, [&](const Vec3& p) {
    const double v = pattern_value(*texture.noise, texture.kind, texture.octaves, p, parts.width);
    sum += ramp_mean(texture.ramp, v - half, v + half);
  });
  return sum / static_cast<double>(parts.count);
}

HeightSample height(const NoiseTexture& texture, const Vec3& p_model, const Vec3& dp_dx,
                    const Vec3& dp_dy) {
  const Parts parts = parts_of(dp_dx, dp_dy, highest_frequency(texture));
  const double half = half_spread(texture, parts);
  HeightSample sum{0.0, Vec3(0.0)};
  each_part(parts, p_model, [&](const Vec3& p) {
    const PatternSample s = pattern(*texture.noise, texture.kind, texture.octaves, p, parts.width);
    const double lo = s.value - half;
    const double hi = s.value + half;
    sum.value += grey(ramp_mean(texture.ramp, lo, hi));
    sum.gradient +=
        s.gradient *
        (hi > lo ? (grey(ramp_at(texture.ramp, hi)) - grey(ramp_at(texture.ramp, lo))) / (hi - lo)
                 : ramp_slope(texture.ramp, s.value));
  });
  const double n = parts.count;
  return {sum.value / n, sum.gradient / n};
}

}  // namespace rt
