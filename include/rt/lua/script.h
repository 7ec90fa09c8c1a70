#pragma once
/// Runs a scene script. The only part of the program that knows Lua; the `gr` table it offers is
/// described in docs/scripting.md.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rt/geometry/mesh.h"
#include "rt/scene/render_job.h"
#include "rt/scene/texture_image.h"

namespace rt::lua {

/// What the binding asks of the rest of the program.
struct Host {
  /// Called by gr.render, once a call, with a snapshot of the graph.
  std::function<void(RenderJob)> render;
  /// Loads an OBJ file. Throws FileError or SceneError.
  std::function<std::shared_ptr<const MeshData>(const std::filesystem::path&)> load_mesh;
  /// Opens a picture for a texture and finds out whether it can be read. Throws FileError.
  std::function<std::shared_ptr<const TextureImage>(const std::filesystem::path&)> open_texture;
  /// Tells the user something that does not stop the script. The text carries script:line.
  std::function<void(const std::string&)> warn;
  /// Called with every file of source text that is run: the script, and what it requires.
  std::function<void(const std::filesystem::path&)> reads = {};
};

/// What a script may use up before it is stopped with ExitCode::limit.
struct Limits {
  /// Bytes: Lua's objects, and what nodes, materials, lights and meshes take beside them.
  std::size_t memory = std::size_t{2} << 30;
  /// Wall time of the script itself, rendering not included.
  double seconds = 60.0;
  /// Instructions of Lua's virtual machine. Counting them costs a third of the speed, so a script
  /// is only counted exactly once it may have used half of a large number (guard.h).
  std::uint64_t instructions = 10'000'000'000;
};

struct Settings {
  Limits limits;
  /// No limits, all of Lua's libraries, files from anywhere.
  bool trust = false;
  /// Further folders that the script may read from.
  std::vector<std::filesystem::path> allowed;
  /// The folder of the textures that come with the program, where scripts may look last; or empty.
  std::filesystem::path shipped_textures;
  /// Calls of what does not exist are skipped with a warning.
  bool lenient = false;
  /// In the global `frame`; empty: there is none.
  std::optional<int> frame;
  TransformOrder order = TransformOrder::pre;
  /// Reports hold Lua's traceback.
  bool verbose = false;
};

/// Runs the script at `path` with `args` in the global `arg` (arg[0] is the script).
/// Throws UserError, its text beginning with script:line where that is known: SceneError for what
/// the script does wrong, FileError when the script cannot be read, and whatever the host throws,
/// with its exit code kept; ExitCode::limit when a limit stopped it. An error that the script
/// itself catches (pcall) is none, memory that was refused included; the limits of time and of
/// instructions, and interruptions, hold all the same.
///
/// A script that does not come back in time from one call, of a library function or of gr.mesh,
/// ends the process: a message on standard error, exit code 4. Only one script runs at a time in a
/// process.
void run_script(const std::filesystem::path& path, const std::vector<std::string>& args,
                const Host& host, const Settings& settings = {});

/// Makes the script that is running, or the next one, end with ExitCode::interrupted at its next
/// instruction. May be called by a signal handler, on any thread, and holds for good.
void interrupt();

}  // namespace rt::lua
