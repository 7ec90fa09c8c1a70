#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace rt::cli {

/// Where something was written, and why not where it should be.
struct Saved {
  std::filesystem::path path;
  std::string refusal;  ///< empty: it is where it should be
};

/// Calls write(path). Where that fails with a FileError - the disk is full, the folder has gone or
/// may not be written to - it is tried with another name, NAME.rescued-PROCESS.EXTENSION, in the
/// working folder, $TMPDIR, /tmp and $HOME. Throws FileError, with the first reason, when all fail.
Saved save_somewhere(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write);

}  // namespace rt::cli
