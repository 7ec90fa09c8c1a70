#include "files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace rt::lua {

namespace fs = std::filesystem;

namespace {

/// Bytes of a source text.
constexpr std::size_t largest_source = std::size_t{64} << 20;

/// The path without symbolic links and dots, as far as it exists. Once is not enough:
/// weakly_canonical stops at the first part that is missing and tidies up the rest as a text, so
/// that of "missing/../link.lua" a link would be left.
fs::path resolved(const fs::path& path, std::error_code& error) {
  const fs::path tidy = fs::weakly_canonical(path, error);
  return error ? tidy : fs::weakly_canonical(tidy, error);
}

bool is_mesh(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".obj";
}

bool lies_in(const fs::path& real, const Folder& folder) {
  if (folder.only_meshes) {
    return is_mesh(real) && real.parent_path() == folder.real;
  }
  const auto [rest, _] =
      std::mismatch(folder.real.begin(), folder.real.end(), real.begin(), real.end());
  return rest == folder.real.end();
}

std::string listed(std::span<const Folder> folders) {
  std::vector<std::string> shown;
  for (const Folder& folder : folders) {
    std::string name = fmt::format("'{}'", folder.shown.empty() ? "." : folder.shown.string());
    if (std::ranges::find(shown, name) == shown.end()) {
      shown.push_back(std::move(name));
    }
  }
  const std::string last = std::move(shown.back());
  shown.pop_back();
  return shown.empty() ? last : fmt::format("{} and {}", fmt::join(shown, ", "), last);
}

/// The folder as messages show it, and where it really is.
Folder folder(const fs::path& shown) {
  std::error_code error;
  const fs::path real = resolved(shown.empty() ? fs::path(".") : shown, error);
  if (error) {
    throw FileError(
        fmt::format("cannot open the folder '{}': {}", shown.string(), error.message()));
  }
  return {shown, fs::absolute(real)};
}

}  // namespace

std::vector<Folder> module_folders(const fs::path& script, const Settings& settings) {
  std::vector<Folder> folders{folder(script.parent_path())};
  for (const fs::path& allowed : settings.allowed) {
    folders.push_back(folder(allowed));
  }
  return folders;
}

namespace {

/// Where a script's data may lie.
std::vector<Folder> data_folders(const fs::path& own, const Settings& settings) {
  std::vector<Folder> folders{folder(own), folder({}), folder(own / "Assets"), folder("Assets")};
  for (const fs::path& allowed : settings.allowed) {
    folders.push_back(folder(allowed));
  }
  return folders;
}

}  // namespace

std::vector<Folder> texture_folders(const fs::path& script, const Settings& settings) {
  std::vector<Folder> folders = data_folders(script.parent_path(), settings);
  if (!settings.shipped_textures.empty()) {
    folders.push_back(folder(settings.shipped_textures));
  }
  return folders;
}

std::vector<Folder> mesh_folders(const fs::path& script, const Settings& settings) {
  const fs::path own = script.parent_path();
  std::vector<Folder> folders = data_folders(own, settings);
  for (const fs::path& above : {own / "..", own / "../Assets"}) {
    folders.push_back(folder(above));
    folders.back().only_meshes = true;
  }
  return folders;
}

FoundFile find_file(const Call& call, const std::string& name, std::span<const Folder> folders) {
  const bool trusted = call.run().settings.trust;
  bool leads_out = false;
  std::string odd;
  for (const Folder& folder : folders) {
    if (folder.only_meshes && fs::path(name).has_parent_path()) {
      continue;  // a plain name, or it does not stand there
    }
    std::error_code error;
    const fs::path candidate = folder.real / name;
    const fs::path real = resolved(candidate, error);
    if (error || name.find('\0') != std::string::npos) {
      continue;
    }
    if (!trusted &&
        std::ranges::none_of(folders, [&](const Folder& f) { return lies_in(real, f); })) {
      leads_out = leads_out || !folder.only_meshes;
    } else if (fs::is_regular_file(real, error)) {
      return {real, (folder.shown / name).string()};
    } else if (fs::exists(real, error)) {
      odd = fs::is_directory(real, error) ? "is a folder" : "is not a regular file";
    }
  }
  if (leads_out) {
    call.fail(fmt::format(
        "'{}' lies outside {}, where a script's files must be; --allow-path FOLDER allows another",
        name, listed(folders)));
  }
  if (!odd.empty()) {
    throw FileError(fmt::format("{}: cannot read '{}': it {}", call.title(), name, odd));
  }
  throw FileError(
      fmt::format("{}: there is no file '{}' in {}", call.title(), name, listed(folders)));
}

std::string read_file(const fs::path& path, const std::string& shown) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    throw FileError(fmt::format("cannot read '{}': it is a folder", shown));
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::string bytes;
  std::array<char, 1 << 14> piece;
  do {
    stream.read(piece.data(), piece.size());
    bytes.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > largest_source) {  // a device may never end
      throw FileError(fmt::format("cannot read '{}': more than {} MB are too many for a script",
                                  shown, largest_source >> 20));
    }
  } while (stream);
  if (!stream.is_open() || stream.bad()) {
    throw FileError(fmt::format("cannot read '{}': {}", shown,
                                errno != 0 ? std::strerror(errno) : "input error"));
  }
  return bytes;
}

int load_text(lua_State* L, std::string source, const std::string& shown) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (source.starts_with(byte_order_mark)) {
    source.erase(0, byte_order_mark.size());
  }
  if (source.starts_with('#')) {
    source.erase(0, source.find('\n'));  // the line's end stays, so that lines keep their numbers
  }
  constexpr const char* text_only = "t";
  constexpr const char* text_or_bytecode = "bt";
  const bool trusted = context(L).settings.trust;
  if (source.starts_with(LUA_SIGNATURE[0]) && !trusted) {
    lua_pushfstring(L, "%s: expected Lua source text, got compiled Lua (bytecode)", shown.c_str());
    return LUA_ERRSYNTAX;
  }
  return luaL_loadbufferx(L, source.data(), source.size(), ("@" + shown).c_str(),
                          trusted ? text_or_bytecode : text_only);
}

}  // namespace rt::lua
