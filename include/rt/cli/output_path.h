#pragma once
#include <filesystem>

namespace rt::cli {

/// Where picture number `index` (from 0) of a script goes. `by_script` is the script's name for it,
/// `by_user` the command line's -o, or empty.
///
/// Without -o the script's name holds; unless the script is trusted it must stay under the working
/// folder (SceneError). With -o naming a folder, the file part of the script's name goes there.
/// With -o naming a file, that is the first picture; later ones get their number: out.png,
/// out.2.png, ...
std::filesystem::path output_path(const std::filesystem::path& by_script,
                                  const std::filesystem::path& by_user, std::size_t index,
                                  bool trusted = false);

}  // namespace rt::cli
