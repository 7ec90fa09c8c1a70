#include "rt/cli/output_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "rt/scene/error.h"

namespace rt::cli {
namespace fs = std::filesystem;
namespace {

bool is_inside(const fs::path& file, const fs::path& folder) {
  const auto [rest, end] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return rest == folder.end();
}

fs::path confined(const fs::path& by_script) {
  std::error_code error;
  const fs::path here = fs::weakly_canonical(fs::current_path(error), error);
  fs::path file = error ? fs::path() : fs::weakly_canonical(here / by_script, error);
  // Twice: what follows a part that does not exist is put in order the first time, not resolved.
  file = error ? file : fs::weakly_canonical(file, error);
  if (error) {
    throw FileError(fmt::format("cannot write {}: {}; choose another name, or give one with -o",
                                by_script.string(), error.message()));
  }
  if (!is_inside(file, here)) {
    throw SceneError(fmt::format(
        "gr.render: the picture '{}' would lie outside the working folder; choose a name below it, "
        "or give the place on the command line with -o",
        by_script.string()));
  }
  return by_script;
}

}  // namespace

fs::path output_path(const fs::path& by_script, const fs::path& by_user, std::size_t index,
                     bool trusted) {
  if (by_user.empty()) {
    return trusted ? by_script : confined(by_script);
  }
  std::error_code ignored;  // of a place that cannot be: check_output() says so
  if (!by_user.has_filename() || fs::is_directory(by_user, ignored)) {
    return by_user / by_script.filename();
  }
  if (index == 0) {
    return by_user;
  }
  fs::path numbered = by_user;
  numbered.replace_filename(
      fmt::format("{}.{}{}", by_user.stem().string(), index + 1, by_user.extension().string()));
  return numbered;
}

}  // namespace rt::cli
