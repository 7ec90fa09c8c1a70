#pragma once
#include "rt/render/plan.h"
#include "rt/render/render.h"

namespace rt {

/// The value of pixel (x, y): the mean over its samples. Adds to the statistics.
Rgb render_pixel(const RenderPlan& plan, int x, int y, RenderStatistics& statistics);

}  // namespace rt
