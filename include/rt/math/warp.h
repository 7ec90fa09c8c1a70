#pragma once
/// Warps of the unit square to directions and discs, each beside its density. Every map here is
/// continuous but for one cut at most, and preserves nearness, so that well spread points stay well
/// spread: a polar disc map instead of the concentric one costs a third more error at 16 samples.
#include <cmath>
#include <numbers>
#include <optional>

#include "rt/math/vec.h"

namespace rt {

inline constexpr double pi = std::numbers::pi;

/// A right-handed orthonormal basis.
struct Frame {
  Vec3 x, y, z;

  Vec3 to_world(const Vec3& local) const { return local.x * x + local.y * y + local.z * z; }
};

/// A basis about the unit vector z, without branches or square roots. Source: Duff et al.,
/// "Building an orthonormal basis, revisited", JCGT 6(1), 2017.
inline Frame frame_about(const Vec3& z) {
  const double sign = std::copysign(1.0, z.z);
  const double a = -1.0 / (sign + z.z);
  const double b = z.x * z.y * a;
  return {{1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

/// A point of the unit disc in polar form, phi in [-pi, pi], and in Cartesian.
struct DiscPoint {
  double r, phi;
  Vec2 xy;
};

/// The concentric map of the square to the unit disc: squares about the centre become circles,
/// areas keep their ratio. Source: Shirley and Chiu, "A low distortion map between disk and
/// square", JGT 2(3), 1997. Only arithmetic, so it is the same on every machine.
DiscPoint disc_polar(const Vec2& u);
Vec2 to_disc(const Vec2& u);
inline constexpr double disc_pdf = 1.0 / pi;

/// A direction about +z, with density cos(theta) / pi: a disc point, lifted (Malley).
Vec3 to_cosine_hemisphere(const Vec2& u);
inline double cosine_hemisphere_pdf(double cos_theta) {
  return cos_theta > 0.0 ? cos_theta / pi : 0.0;
}

/// A cone of directions, kept as 1 - cos of its half-angle: that number is exact for the tiniest
/// cones, where the cosine itself rounds to 1. In [0, 2]; 2 is the whole sphere.
struct Cone {
  double one_minus_cos;

  double solid_angle() const { return 2.0 * pi * one_minus_cos; }
  double pdf() const { return 1.0 / solid_angle(); }
  /// The cone of half-angle asin(sqrt(sin2)), at most a right angle.
  static Cone from_sin2(double sin2) { return {sin2 / (1.0 + std::sqrt(1.0 - sin2))}; }
};

/// A unit direction uniform in the cone about +z.
Vec3 to_cone(const Vec2& u, const Cone& cone);

/// A direction towards a sphere, uniform in the solid angle it subtends.
struct SphereSample {
  Vec3 direction;   ///< unit
  double distance;  ///< to the sphere's near side along it
  double pdf;       ///< per solid angle, the same for all u
};

/// Empty when p lies inside the sphere or on it: then it surrounds p, or covers a hemisphere, and
/// there is no cone.
std::optional<SphereSample> sample_sphere(const Vec2& u, const Vec3& p, const Vec3& centre,
                                          double radius);

}  // namespace rt
