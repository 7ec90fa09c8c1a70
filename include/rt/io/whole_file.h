#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace rt::io {

/// Throws FileError when no file can be written under that name: its folder does not exist or may
/// not be written to, the name is too long, or that of a folder, a device or a pipe. So a mistake
/// shows before the rendering, not after.
void check_place(const std::filesystem::path& path);

/// Writes a file that appears whole or not at all: the bytes go to a temporary name in the same
/// folder, onto the disk, and only then take the name. On failure the temporary is removed and
/// FileError thrown, which names the file, the reason and what to try; a file that stood under the
/// name before is then still there. A symbolic link to a file is
/// replaced, not followed.
///
/// A process that is killed leaves its temporary, `.raytracer-PROCESS-N.tmp`; the first file that a
/// later process writes to the folder removes those that are over a minute old and that no process
/// holds (by its lock).
void write_whole_file(const std::filesystem::path& path, std::span<const unsigned char> bytes);

/// Removes the temporary that is being written, if there is one; the writing then fails. For a
/// signal handler that ends the process.
void abandon_temporary() noexcept;

}  // namespace rt::io
