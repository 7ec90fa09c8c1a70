#pragma once
/// Runs a scene script. The only part of the program that knows Lua; the `gr` table it offers is
/// described in docs/scripting.md.
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rt/geometry/mesh.h"
#include "rt/scene/render_job.h"

namespace rt::lua {

/// What the binding asks of the rest of the program.
struct Host {
  /// Called by gr.render, once a call, with a snapshot of the graph.
  std::function<void(RenderJob)> render;
  /// Loads an OBJ file. Throws FileError or SceneError.
  std::function<std::shared_ptr<const MeshData>(const std::filesystem::path&)> load_mesh;
  /// Tells the user something that does not stop the script. The text carries script:line.
  std::function<void(const std::string&)> warn;
};

/// What a script may use up.
struct Limits {
  std::size_t memory = std::size_t{2} << 30;  ///< bytes of Lua's own objects
};

/// Runs the script at `path` with `args` in the global `arg` (arg[0] is the script).
/// Throws UserError, its text beginning with script:line where that is known: SceneError for what
/// the script does wrong, FileError when the script cannot be read, and whatever the host throws,
/// with its exit code kept; ExitCode::limit when a limit stopped it. An error that the script
/// itself catches (pcall) is none.
void run_script(const std::filesystem::path& path, const std::vector<std::string>& args,
                const Host& host, const Limits& limits = {});

}  // namespace rt::lua
