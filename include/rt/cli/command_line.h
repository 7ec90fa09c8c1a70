#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rt/cli/frames.h"
#include "rt/io/texture.h"
#include "rt/lua/script.h"
#include "rt/render/film.h"
#include "rt/scene/error.h"
#include "rt/scene/options.h"

namespace rt::cli {

enum class ProgressStyle { automatic, plain, json, none };

/// What the user asked for on the command line.
struct CommandLine {
  std::filesystem::path scene;
  std::vector<std::string> arguments;  ///< for the script, after "--"
  std::filesystem::path output;        ///< empty: as the script says
  std::optional<std::pair<int, int>> size;
  std::optional<Crop> crop;
  std::optional<Frames> frames;  ///< empty: one run of the script, without a global `frame`
  int threads = 0;               ///< 0: one a processor
  std::vector<std::pair<const OptionSpec*, OptionValue>>
      settings;  ///< in order, on top of the script's
  std::filesystem::path stats;
  std::filesystem::path report;
  bool explain = false;  ///< say what would be done, and render nothing
  bool resume = false;
  double checkpoint_every = 0.0;          ///< seconds; 0: only when interrupted
  std::filesystem::path checkpoint_file;  ///< empty: beside the first picture
  std::vector<std::string> words;         ///< the command line as given, up to "--"
  ProgressStyle progress = ProgressStyle::automatic;
  bool quiet = false;
  io::TextureLimits textures;
  lua::Settings script;             ///< what the script may do
  std::filesystem::path new_scene;  ///< set: write a starter scene there, and nothing else
};

/// The command line is wrong: exit code 2.
class UsageError : public UserError {
 public:
  explicit UsageError(const std::string& message) : UserError(ExitCode::command_line, message) {}
};

/// Reads the command line. Prints and returns nothing when --help or --version was asked for.
/// Throws UsageError.
std::optional<CommandLine> parse_command_line(int argc, const char* const* argv);

}  // namespace rt::cli
