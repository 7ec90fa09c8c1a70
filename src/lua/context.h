#pragma once
/// What one run of a script knows, beside its Lua state.
#include <filesystem>
#include <lua.hpp>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "rt/lua/script.h"
#include "rt/scene/error.h"

namespace rt::lua {

/// A folder that scripts may read from.
struct Folder {
  std::filesystem::path shown;  ///< as the user would write it, for messages
  std::filesystem::path real;   ///< absolute, without symbolic links
};

struct Context {
  const Host& host;
  std::string script;     ///< the script's path as the user gave it
  Folder script_folder;   ///< where the script's modules and meshes lie
  Folder working_folder;  ///< where meshes may lie, too
  /// Modules that are being loaded, outermost first, to report a loop of requires.
  std::vector<std::string> loading;
  /// Meshes by their real path: nodes of one file share its triangles.
  std::map<std::filesystem::path, std::shared_ptr<const MeshData>> meshes;
  /// What has been said already, and will not be said again.
  std::set<std::string, std::less<>> said;
  /// Lua carries errors as texts; this keeps the exit code of the latest that had its own.
  std::string coded_message;
  ExitCode coded_code = ExitCode::scene;
};

/// The context of a state and of all its coroutines: Lua copies the extra space to each.
inline Context*& context_slot(lua_State* L) {
  return *static_cast<Context**>(lua_getextraspace(L));
}
inline Context& context(lua_State* L) { return *context_slot(L); }

/// "scene.lua:12", the line being run: that of the innermost Lua function that called the running
/// C function. Empty when there is none.
std::string location(lua_State* L);

/// Tells the user `text`, with its location, unless `topic` has been told before.
void warn_once(lua_State* L, const std::string& topic, const std::string& text);

}  // namespace rt::lua
