#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "rt/scene/camera.h"
#include "rt/scene/light.h"
#include "rt/scene/node.h"
#include "rt/scene/options.h"

namespace rt {

/// One call of gr.render: a snapshot that owns all it needs.
struct RenderJob {
  InstanceList instances;
  Camera camera;
  Rgb ambient{0.0};
  std::vector<Light> lights;
  RenderOptions options;         ///< the script's; the command line's come on top
  std::filesystem::path output;  ///< as the script gave it
  std::string where;             ///< script:line of the call
};

}  // namespace rt
