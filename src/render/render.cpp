#include "rt/render/render.h"

#include "rt/render/rendering.h"

namespace rt {

RenderResult render(const RenderPlan& plan, const Crop& crop, const ProgressFunction& progress) {
  Rendering rendering(plan, crop);
  rendering.run(progress, {});
  return rendering.take();
}

}  // namespace rt
