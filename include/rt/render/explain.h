#pragma once
#include <string>

#include "rt/render/plan.h"

namespace rt {

/// In words: what a scene needs, what was chosen for it and why, what was left out, and the cost to
/// expect. For that a few hundred rays are traced; their time is this machine's, the rest of the
/// text follows from the plan alone. `threads` that will render.
std::string explain(const RenderPlan& plan, int threads);

}  // namespace rt
