#include "files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace rt::lua {

namespace fs = std::filesystem;

namespace {

bool lies_in(const fs::path& real, const Folder& folder) {
  const auto [rest, _] =
      std::mismatch(folder.real.begin(), folder.real.end(), real.begin(), real.end());
  return rest == folder.real.end();
}

std::string listed(std::span<const Folder> folders) {
  std::string text;
  for (const Folder& folder : folders) {
    const std::string shown = folder.shown.empty() ? "." : folder.shown.string();
    text += fmt::format("{}'{}'", text.empty() ? "" : " and ", shown);
  }
  return text;
}

}  // namespace

Folder folder(const fs::path& shown) {
  std::error_code error;
  fs::path real = fs::weakly_canonical(shown.empty() ? fs::path(".") : shown, error);
  if (error) {
    throw FileError(
        fmt::format("cannot open the folder '{}': {}", shown.string(), error.message()));
  }
  return {shown, fs::absolute(real)};
}

FoundFile find_file(const Call& call, const std::string& name, std::span<const Folder> folders) {
  bool leads_out = false;
  for (const Folder& folder : folders) {
    std::error_code error;
    const fs::path candidate = folder.real / name;
    const fs::path real = fs::weakly_canonical(candidate, error);
    if (error || name.find('\0') != std::string::npos) {
      continue;
    }
    if (std::ranges::none_of(folders, [&](const Folder& f) { return lies_in(real, f); })) {
      leads_out = true;
    } else if (fs::is_regular_file(real, error)) {
      return {real, (folder.shown / name).string()};
    }
  }
  if (leads_out) {
    call.fail(
        fmt::format("'{}' lies outside {}, where a script's files must be", name, listed(folders)));
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
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
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
  if (source.starts_with(LUA_SIGNATURE[0])) {
    lua_pushfstring(L, "%s: expected Lua source text, got compiled Lua (bytecode)", shown.c_str());
    return LUA_ERRSYNTAX;
  }
  return luaL_loadbufferx(L, source.data(), source.size(), ("@" + shown).c_str(), "t");
}

}  // namespace rt::lua
