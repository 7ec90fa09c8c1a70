#pragma once
#include <vector>

#include "rt/math/bounds.h"
#include "rt/render/plan.h"

namespace rt {

/// Fills RenderPlan::media and media_ranges. `boxes`: of all instances.
void find_media(RenderPlan& plan, const std::vector<Bounds>& boxes);

}  // namespace rt
