#pragma once
#include <filesystem>

namespace rt::cli {

/// Writes a commented scene to start from, with its picture named after it. Throws FileError when
/// the file is there already or cannot be written.
void write_starter_scene(const std::filesystem::path& file);

}  // namespace rt::cli
