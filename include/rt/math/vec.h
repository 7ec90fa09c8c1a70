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

/// The largest absolute component.
inline double max_abs(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace rt
