#pragma once
#include <optional>

#include "rt/math/vec.h"

namespace rt {

/// An affine map p -> linear p + offset.
struct Affine {
  Mat3 linear{1.0};
  Vec3 offset{0.0};

  Vec3 point(const Vec3& p) const { return linear * p + offset; }
  Vec3 vector(const Vec3& v) const { return linear * v; }

  static Affine translation(const Vec3& by);
  static Affine scaling(const Vec3& factors);
  /// Rotation about a coordinate axis (0, 1, 2) through the origin, right-handed. Multiples of 90
  /// degrees give exact matrices.
  static Affine rotation(int axis, double degrees);
};

/// The map that applies `inner` first. Evaluated in extended precision, rounded once.
Affine operator*(const Affine& outer, const Affine& inner);

/// The inverse, evaluated in extended precision. Empty when the map is singular, or when it or its
/// inverse is not finite.
std::optional<Affine> inverse(const Affine& a);

/// Largest row sum of absolute values: bounds how much the map stretches the maximum norm.
double norm(const Mat3& m);

}  // namespace rt
