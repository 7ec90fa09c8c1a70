#pragma once
/// texture.h at several points.
#include "rt/math/wide.h"
#include "rt/scene/texture.h"

namespace rt {

Wide3 colour(const Checker& checker, const Wide3& p_model, const Wide3& width);

}  // namespace rt
