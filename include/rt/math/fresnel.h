#pragma once
/// Reflection and refraction at a smooth interface between dielectrics of indices n1 (the side the
/// ray is on) and n2.
#include <cmath>
#include <optional>

#include "rt/math/vec.h"

namespace rt {

/// cos^2 of the angle of refraction; negative where all is reflected, and 0 at the critical angle.
/// From Snell's law n2^2 cos2^2 = n2^2 - n1^2 sin1^2 = (n2-n1)(n2+n1) + n1^2 cos1^2: no difference
/// of nearly equal products when n1 and n2 agree, nor at normal incidence.
template <class Real>
Real cos2_transmitted(const Real& cos_i, const Real& n1, const Real& n2) {
  return ((n2 - n1) * (n2 + n1) + n1 * cos_i * (n1 * cos_i)) / (n2 * n2);
}

/// The exact unpolarised reflectance, the mean of
///     Rs = ((n1 c1 - n2 c2)/(n1 c1 + n2 c2))^2,  Rp = ((n2 c1 - n1 c2)/(n2 c1 + n1 c2))^2,
/// and 1 beyond the critical angle. cos_i in [0,1]. Relative error below 1e-13, however close the
/// indices and except for the error of cos_i itself near the critical angle; 0 for equal indices.
double fresnel(double cos_i, double n1, double n2);

/// The mirror direction of d, to rounding of unit length. n unit, of either sign.
Vec3 reflect(const Vec3& d, const Vec3& n);

/// The refracted direction, unit, or empty where all is reflected: exactly where fresnel gives 1 by
/// total reflection. d and n unit, n on the ray's side: d.n <= 0.
std::optional<Vec3> refract(const Vec3& d, const Vec3& n, double n1, double n2);

}  // namespace rt
