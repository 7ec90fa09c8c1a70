#pragma once
/// What one run of a script knows, beside its Lua state.
#include <array>
#include <deque>
#include <filesystem>
#include <lua.hpp>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "guard.h"
#include "memory.h"
#include "rt/lua/script.h"
#include "rt/scene/error.h"

namespace rt::lua {

/// A folder that scripts may read from.
struct Folder {
  std::filesystem::path shown;  ///< as the user would write it, for messages
  std::filesystem::path real;   ///< absolute, without symbolic links
  /// Only OBJ files that lie in the folder itself may be read.
  bool only_meshes = false;
};

struct Context {
  const Host& host;
  const Settings& settings;
  Guard& guard;
  std::shared_ptr<MemoryMeter> memory;
  std::string script;  ///< the script's path as the user gave it
  /// Where the script's modules lie: its own folder, then those that the user allows.
  std::vector<Folder> module_folders;
  /// Where its meshes lie.
  std::vector<Folder> mesh_folders;
  /// Where the pictures of its textures lie.
  std::vector<Folder> texture_folders;
  /// The metatable of each kind of userdata (handle.h).
  std::array<const void*, 4> metatables = {};
  /// Modules that are being loaded, outermost first, to report a loop of requires.
  std::vector<std::string> loading = {};
  /// Meshes by their real path: nodes of one file share its triangles.
  std::map<std::filesystem::path, std::shared_ptr<const MeshData>> meshes = {};
  /// Pictures by their real path: textures of one file share what is decoded of it.
  std::map<std::filesystem::path, std::shared_ptr<const TextureImage>> pictures = {};
  /// What has been said already, and will not be said again.
  std::set<std::string, std::less<>> said = {};
  /// What shared_location() returned last, and of what.
  struct Place {
    std::string file;
    int line = 0;
    std::shared_ptr<const std::string> text;
  } last_place = {};
  /// The files of what has been run, by the names that messages give them.
  std::map<std::string, std::filesystem::path> sources = {};
  /// Lua carries errors as texts; this keeps the exit codes of the latest that had their own.
  struct CodedError {
    std::string message;
    ExitCode code;
  };
  std::deque<CodedError> coded_errors = {};
  /// Where Lua was last refused memory: "scene.lua:12", or empty.
  std::string refused_at = {};
  bool refused = false;
  bool rendered = false;  ///< gr.render has been called
  /// Lua's traceback of the error that ended the script.
  std::string traceback = {};
  /// Materials that no node has been given, by where they were made. Only the script's own.
  std::map<const void*, std::string> unused_materials = {};
};

/// The context of a state and of all its coroutines: Lua copies the extra space to each.
inline Context*& context_slot(lua_State* L) {
  return *static_cast<Context**>(lua_getextraspace(L));
}
inline Context& context(lua_State* L) { return *context_slot(L); }

/// "scene.lua:12", the line being run: that of the innermost Lua function that called the running
/// C function. Empty when there is none.
std::string location(lua_State* L);

/// The same, shared with the calls before it from the same line; null when there is none.
std::shared_ptr<const std::string> shared_location(lua_State* L);

/// "scene.lua:12: text"; where no line is being run, the name `otherwise` stands in its place.
std::string at_location(lua_State* L, const std::string& otherwise, const std::string& text);

/// Tells the user `text`, with its location, unless `topic` has been told before.
void warn_once(lua_State* L, const std::string& topic, const std::string& text);

/// Charges `bytes` of memory that is not Lua's. Throws UserError when the limit does not allow them
/// even after garbage has been collected.
void charge(lua_State* L, Charge& charge, std::size_t bytes);

/// What the memory limit says when it is reached.
std::string memory_limit_text(const MemoryMeter& meter);

/// A value and what it is charged for.
template <class T>
struct Charged {
  T value;
  Charge charge;
};

/// The value shared, and charged for until nobody shares it any more. `beside` counts what it holds
/// outside itself.
template <class T>
std::shared_ptr<T> make_charged(lua_State* L, T value, std::size_t beside = 0) {
  Charge cost(context(L).memory);
  charge(L, cost, sizeof(Charged<T>) + beside);
  auto both = std::make_shared<Charged<T>>(Charged<T>{std::move(value), std::move(cost)});
  T* inner = &both->value;
  return {std::move(both), inner};
}

}  // namespace rt::lua
