#pragma once
/// Files that scripts name: found, and kept inside the folders that scripts may read.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "call.h"

namespace rt::lua {

struct FoundFile {
  std::filesystem::path real;
  std::string shown;  ///< as in messages
};

/// Where a script's modules are looked for: its folder, and those that the user allows.
std::vector<Folder> module_folders(const std::filesystem::path& script, const Settings& settings);

/// Where its meshes are looked for, in this order: its folder and the working folder, Assets/ in
/// both, the folders that the user allows; and, where scripts of the course framework expect them,
/// the folder above the script's and Assets/ in that, for OBJ files only.
std::vector<Folder> mesh_folders(const std::filesystem::path& script, const Settings& settings);

/// Where its textures are looked for, in this order: its folder and the working folder, Assets/ in
/// both, the folders that the user allows, and the folder of the textures that come with the
/// program.
std::vector<Folder> texture_folders(const std::filesystem::path& script, const Settings& settings);

/// The first regular file called `name` in one of `folders`. Throws SceneError when the name leads
/// out of them, be it by "..", an absolute path or a symbolic link, unless the script is trusted;
/// FileError when there is none.
FoundFile find_file(const Call& call, const std::string& name, std::span<const Folder> folders);

/// The bytes of a file of source text, 64 MB at most. Throws FileError.
std::string read_file(const std::filesystem::path& path, const std::string& shown);

/// Compiles Lua source text and leaves the function on the stack; a first line that starts with #
/// is skipped. Returns a status as lua_load does, with the message on the stack. Bytecode is
/// refused.
int load_text(lua_State* L, std::string source, const std::string& shown);

}  // namespace rt::lua
