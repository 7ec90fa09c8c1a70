#pragma once
#include <vector>

#include "rt/math/bounds.h"
#include "rt/render/plan.h"

namespace rt {

/// Fills RenderPlan::media and media_ranges, where anything is transmissive.
void find_media(RenderPlan& plan);

}  // namespace rt
