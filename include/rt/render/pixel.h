#pragma once
#include "rt/render/render.h"
#include "rt/render/tracer.h"

namespace rt {

/// The value of pixel (x, y): the mean over its samples. Adds to the statistics.
Rgb render_pixel(Tracer& tracer, int x, int y, RenderStatistics& statistics);

}  // namespace rt
