#pragma once
#include <string>
#include <vector>

#include "rt/render/film.h"
#include "rt/render/plan.h"

namespace rt {

/// What is likely to be a mistake in a scene whose picture is done: nothing in view, an eye shut in
/// an object, a picture all black, a light inside an opaque solid. `plan` is of `job`. A few rays
/// are cast; what they leave in doubt is not warned of.
std::vector<std::string> scene_warnings(const RenderJob& job, const RenderPlan& plan,
                                        const Film& film);

}  // namespace rt
