#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace rt::io {

/// Writes a file that appears whole or not at all: the bytes go to a temporary name in the same
/// folder, onto the disk, and only then take the name. On failure the temporary is removed and
/// FileError thrown, which names the file, the reason and what to try; a file that stood under the
/// name before is then still there. A symbolic link under that name is replaced, not followed.
void write_whole_file(const std::filesystem::path& path, std::span<const unsigned char> bytes);

}  // namespace rt::io
