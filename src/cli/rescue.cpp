#include "rt/cli/rescue.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <vector>

#include "rt/scene/error.h"

namespace rt::cli {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> other_folders() {
  std::vector<fs::path> folders;
  std::error_code error;
  folders.push_back(fs::current_path(error));
  for (const char* name : {"TMPDIR", "", "HOME"}) {
    const char* value = *name == '\0' ? "/tmp" : std::getenv(name);
    if (value != nullptr && *value != '\0') {
      folders.emplace_back(value);
    }
  }
  return folders;
}

}  // namespace

Saved save_somewhere(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  std::optional<FileError> first;
  try {
    write(path);
    return {path, {}};
  } catch (const FileError& error) {
    first = error;
  }
  const std::string name =
      fmt::format("{}.rescued-{}{}", path.stem().string(), ::getpid(), path.extension().string());
  for (const fs::path& folder : other_folders()) {
    try {
      if (!folder.empty()) {
        write(folder / name);
        return {folder / name, first->what()};
      }
    } catch (const FileError&) {  // the first reason says most
    }
  }
  throw FileError(
      fmt::format("{}; nor could it be kept in the working folder, $TMPDIR, /tmp or "
                  "$HOME",
                  first->what()));
}

}  // namespace rt::cli
