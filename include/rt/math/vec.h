#pragma once
/// The vector types of the whole program: GLM's, in double precision.
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace rt {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;

/// Linear Rec.709 radiance or reflectance, one component a channel.
using Rgb = glm::dvec3;

/// True when no component is NaN or infinite.
inline bool all_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// a where m, else b: for what is written for one number and for several (wide.h) alike.
inline double select(bool m, double a, double b) { return m ? a : b; }
inline const Vec3& select(bool m, const Vec3& a, const Vec3& b) { return m ? a : b; }

/// The largest absolute component.
inline double max_abs(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace rt
