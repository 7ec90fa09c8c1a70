#pragma once
/// The vector types of the whole program: GLM's, in double precision.
#include <glm/glm.hpp>

namespace rt {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;

/// Linear Rec.709 radiance or reflectance, one component a channel.
using Rgb = glm::dvec3;

/// True when no component is NaN or infinite.
bool all_finite(const Vec3& v);

/// The largest absolute component.
double max_abs(const Vec3& v);

}  // namespace rt
