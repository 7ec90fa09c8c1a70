#pragma once
#include "rt/math/vec.h"

namespace rt {

/// A power-cosine lobe about a direction m, confined to the hemisphere of a normal n and
/// renormalised: density
///     p(w) = (e+1)/(2 pi) max(0, m.w)^e / M   where n.w > 0, else 0,
/// where M, the share of the lobe above the horizon, makes p integrate to 1.
///
/// Made once a material; draws are const and thread-safe.
class PowerCosineLobe {
 public:
  /// exponent >= 0, finite. Glossiness g of the specification is exponent 2/g^2 - 2.
  explicit PowerCosineLobe(double exponent);

  double exponent() const { return exponent_; }
  bool operator==(const PowerCosineLobe&) const = default;

  /// M as a function of cos = m.n >= 0; in [1/2, 1]. Relative error below 1e-12.
  double mass_above(double cos_theta) const;

  /// p(w); all arguments unit.
  double pdf(const Vec3& w, const Vec3& m, const Vec3& n) const;

  struct Sample {
    Vec3 direction;  ///< unit; never below the horizon
    double weight;   ///< p over the density drawn from, in (0, 2], mean 1: multiply radiance by it
  };
  /// Draws w. Rejects nothing and is continuous in u but for one cut. Requires m.n >= 0 (the mirror
  /// direction of a ray from above), unit vectors.
  Sample sample(const Vec2& u, const Vec3& m, const Vec3& n) const;

 private:
  double exponent_;
  double beta_scale_;  ///< 1 / (a B(a, 1/2)), a = (exponent + 1) / 2
};

}  // namespace rt
