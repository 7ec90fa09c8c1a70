// Fuzz target: a script.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "rt/io/obj.h"
#include "rt/io/texture.h"
#include "rt/lua/script.h"
#include "rt/scene/error.h"
#include "script_grammar.h"

namespace {

/// A folder of this process, for the script to lie in.
const std::filesystem::path& folder() {
  static const std::filesystem::path path = [] {
    char pattern[] = "/tmp/rt-fuzz-XXXXXX";
    const std::filesystem::path made = mkdtemp(pattern);
    if (std::freopen("/dev/null", "w", stdout) == nullptr) {  // what scripts print
      std::abort();
    }
    return made;
  }();
  return path;
}

void check(const rt::RenderJob& job) {
  for (const rt::Instance& instance : job.instances) {
    if (!instance.shape || !instance.material ||
        !rt::all_finite(instance.world_from_model.offset) ||
        !rt::inverse(instance.world_from_model)) {
      std::abort();
    }
  }
  if (job.options.width < 1 || job.options.height < 1 || !(job.camera.fov > 0)) {
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path file = folder() / "scene.lua";
  std::string text(data, data + size);
  if (size > 0 && data[0] % 2 == 1) {
    text = ScriptGrammar({data + 1, size - 1}).script();
  }
  std::ofstream(file, std::ios::binary) << text;
  const auto open_texture = [](const std::filesystem::path& picture) {
    return rt::io::open_texture(picture);
  };
  const rt::lua::Host host{check, rt::io::load_obj, open_texture, [](const std::string&) {}};
  rt::lua::Settings settings;
  settings.limits = {.memory = 32 << 20, .seconds = 20.0, .instructions = 200'000};
  settings.lenient = size > 1 && data[1] % 2 == 1;
  settings.verbose = true;
  try {
    rt::lua::run_script(file, {"argument"}, host, settings);
  } catch (const rt::UserError& error) {
    if (error.report().empty() || std::string(error.what()).find("internal error") == 0) {
      std::abort();
    }
  }
  return 0;
}
