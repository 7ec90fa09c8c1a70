#include "rt/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace rt::cli {
namespace {

std::string flag_of(const OptionSpec& spec) {
  std::string flag = "--" + std::string(spec.name);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::string with_suggestion(const std::string& text, std::string_view given,
                            std::span<const std::string_view> known, std::string_view prefix = "") {
  const std::string near = nearest_name(given, known);
  return near.empty() ? text : fmt::format("{}; did you mean {}{}?", text, prefix, near);
}

/// Names that --disable takes: the options that are switches.
std::vector<std::string_view> feature_names() {
  std::vector<std::string_view> names;
  for (const OptionSpec& spec : option_specs()) {
    if (!spec.on_command_line) {
      names.push_back(spec.name);
    }
  }
  return names;
}

void disable(CommandLine& line, const std::string& name) {
  const OptionSpec* spec = find_option(name);
  if (spec == nullptr || spec->on_command_line) {
    const auto names = feature_names();
    throw UsageError(with_suggestion(
        fmt::format("--disable: '{}' is not a feature; there are {}", name, fmt::join(names, ", ")),
        name, names));
  }
  line.settings.emplace_back(spec, OptionValue(false));
}

Crop parse_crop(const std::string& text) {
  int v[4] = {};
  const char* p = text.data();
  const char* end = p + text.size();
  for (int i = 0; i < 4; ++i) {
    const auto [next, error] = std::from_chars(p, end, v[i]);
    const bool last = i == 3;
    if (error != std::errc() || (last ? next != end : next == end || *next != ',') || v[i] < 0) {
      throw UsageError(
          fmt::format("--crop: expected X,Y,WIDTH,HEIGHT in whole pixels, got '{}'", text));
    }
    p = next + 1;
  }
  if (v[2] == 0 || v[3] == 0) {
    throw UsageError(
        fmt::format("--crop: '{}' is empty; width and height must be at least 1", text));
  }
  return {v[0], v[1], v[2], v[3]};
}

/// Everything CLI11 fills in before it is checked.
struct Raw {
  std::string scene, size, crop, frame, frames, progress = "auto", order = "pre";
  std::size_t script_memory = 0;  // MB; 0: not given
  std::vector<std::string> disabled;
  std::vector<std::string> values = std::vector<std::string>(option_specs().size());
};

/// What the script may do and use up.
void declare_script(CLI::App& app, lua::Settings& script, Raw& raw) {
  app.add_option("--script-memory", raw.script_memory, "memory for the script (default 2048)")
      ->type_name("MB")
      ->check(CLI::Range(1, 1 << 30));
  app.add_option("--script-time", script.limits.seconds,
                 "time for the script, rendering not included (default 60)")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.001, 1e9));
  app.add_option("--script-instructions", script.limits.instructions,
                 "instructions for the script (default 10000000000)")
      ->type_name("N")
      ->check(CLI::Range(1.0, 1e18));
  app.add_option("--allow-path", script.allowed, "a further folder the script may read from")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory)
      ->allow_extra_args(false);  // one each time it is given: the scene may follow
  app.add_flag("--trust", script.trust,
               "let the script do anything: all libraries, files anywhere, no limits");
  app.add_flag("--lenient", script.lenient, "skip calls of what does not exist, with a warning");
  app.add_option(
         "--transform-order", raw.order,
         "pre|post: node:rotate turns about the parent's origin (default) or the node's own")
      ->check(CLI::IsMember({"pre", "post"}))
      ->type_name("ORDER");
}

/// What textures may use up. Not for scripts to say: these guard against them.
void declare_textures(CLI::App& app, io::TextureLimits& textures) {
  app.add_option("--texture-memory", textures.cache_megabytes,
                 "memory for decoded textures (default 512)")
      ->type_name("MB")
      ->check(CLI::Range(16, 1 << 20));
  app.add_option("--max-texture-size", textures.largest_side,
                 "widest and highest picture that a texture may be (default 16384)")
      ->type_name("PIXELS")
      ->check(CLI::Range(1, 1 << 20));
}

/// An empty value would pass for an option that was not given.
void refuse_empty_values(CLI::App& app) {
  const auto not_empty = [](const std::string& value) {
    return std::string(value.empty() ? "its value is empty" : "");
  };
  for (CLI::Option* option : app.get_options()) {
    if (!option->get_positional() && option->get_expected_min() > 0) {
      option->check(not_empty);
    }
  }
}

void declare(CLI::App& app, CommandLine& line, Raw& raw) {
  app.add_option("scene", raw.scene, "the scene script")->type_name("SCENE.lua");
  app.add_option(
         "-o,--output", line.output,
         "where the picture goes; .png .bmp .exr .tga .jpg. A folder keeps the script's name")
      ->type_name("FILE");
  app.add_option("-s,--size", raw.size, "size of the picture, instead of the script's")
      ->type_name("WxH");
  app.add_option("--crop", raw.crop, "render this part only")->type_name("X,Y,W,H");
  CLI::Option* frames =
      app.add_option("--frames", raw.frames,
                     "run the script for each frame, its number in the global frame")
          ->type_name("FIRST..LAST");
  app.add_option("--frame", raw.frame, "one frame of these")->type_name("N")->excludes(frames);
  app.add_option("-t,--threads", line.threads, "threads (default: one a processor)")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  for (std::size_t i = 0; i < option_specs().size(); ++i) {
    const OptionSpec& spec = option_specs()[i];
    if (spec.on_command_line) {
      app.add_option(flag_of(spec), raw.values[i], std::string(spec.help))
          ->type_name(std::string(spec.value));
    }
  }
  app.add_option("--disable", raw.disabled,
                 fmt::format("switch features off: {}", fmt::join(feature_names(), ",")))
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("LIST");
  app.add_option("--stats", line.stats, "write times, rays and memory as JSON")
      ->type_name("FILE.json");
  app.add_option("--report", line.report,
                 "write a page with the picture, maps of its error and samples, times and plan")
      ->type_name("FILE.html");
  app.add_flag("--explain", line.explain,
               "say what the scene needs and what was chosen for it; no picture is made");
  app.add_flag("--resume", line.resume,
               "go on where an interrupted run stopped: from the checkpoint beside its picture");
  app.add_option("--checkpoint", line.checkpoint_every,
                 "write a checkpoint every so often, not only when interrupted")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.01, 1e9));
  app.add_option("--checkpoint-file", line.checkpoint_file,
                 "where checkpoints are (default: the first picture's name, then .checkpoint)")
      ->take_last()  // the command that goes on from a rescued one names that after the first
      ->type_name("FILE");
  app.add_option("--progress", raw.progress, "auto|plain|json|none, on standard error")
      ->check(CLI::IsMember({"auto", "plain", "json", "none"}))
      ->type_name("STYLE");
  app.add_flag("-q,--quiet", line.quiet, "say nothing but warnings and errors");
  app.add_flag("-v,--verbose", line.script.verbose, "show Lua's traceback below errors");
  app.add_option("--new", line.new_scene, "write a commented scene to start from")
      ->type_name("SCENE.lua");
  declare_script(app, line.script, raw);
  declare_textures(app, line.textures);
  refuse_empty_values(app);
}

[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) {
    throw UsageError(error.what());
  }
  const std::vector<std::string> extras = app.remaining();
  const std::string given = extras.empty() ? "" : extras.front();
  if (given.find_first_not_of('-') == given.npos || !given.starts_with('-')) {
    throw UsageError(fmt::format(
        "'{}' is one file too many: one scene at a time (arguments for the script come after --)",
        given));
  }
  std::vector<std::string> flags;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      flags.push_back(name);
    }
  }
  const std::vector<std::string_view> views(flags.begin(), flags.end());
  throw UsageError(with_suggestion(fmt::format("there is no option {}", given),
                                   given.substr(given.find_first_not_of('-')), views, "--") +
                   " (--help lists them)");
}

void interpret(CommandLine& line, const Raw& raw) {
  line.scene = raw.scene;
  line.script.order = raw.order == "post" ? TransformOrder::post : TransformOrder::pre;
  if (raw.script_memory > 0) {
    line.script.limits.memory = raw.script_memory << 20;
  }
  if (raw.scene.empty() && line.new_scene.empty()) {
    throw UsageError("no scene given; expected: raytracer SCENE.lua [options] (see --help)");
  }
  for (std::size_t i = 0; i < raw.values.size(); ++i) {
    if (raw.values[i].empty()) {
      continue;
    }
    const OptionSpec& spec = option_specs()[i];
    try {
      RenderOptions scratch;
      spec.set(scratch, OptionValue(raw.values[i]));
    } catch (const std::invalid_argument& error) {
      throw UsageError(fmt::format("--{}: {}", flag_of(spec).substr(2), error.what()));
    }
    line.settings.emplace_back(&spec, OptionValue(raw.values[i]));
  }
  for (const std::string& name : raw.disabled) {
    disable(line, name);
  }
  if (!raw.size.empty()) {
    try {
      line.size.emplace();
      parse_size(raw.size, line.size->first, line.size->second);
    } catch (const std::invalid_argument& error) {
      throw UsageError(fmt::format("--size: {}", error.what()));
    }
  }
  if (!raw.crop.empty()) {
    line.crop = parse_crop(raw.crop);
  }
  if (!raw.frame.empty()) {
    line.frames = parse_frame(raw.frame);
  } else if (!raw.frames.empty()) {
    line.frames = parse_frames(raw.frames);
  }
  line.progress = raw.progress == "plain"  ? ProgressStyle::plain
                  : raw.progress == "json" ? ProgressStyle::json
                  : raw.progress == "none" ? ProgressStyle::none
                                           : ProgressStyle::automatic;
}

}  // namespace

std::optional<CommandLine> parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  Raw raw;
  CLI::App app{"Renders the pictures that a Lua scene script describes.", "raytracer"};
  app.set_version_flag("--version", "raytracer " RT_VERSION);
  app.footer("Arguments after -- go to the script, in the global table arg.");
  declare(app, line, raw);

  const char* const* end = argv + argc;
  const char* const* split =
      std::find_if(argv, end, [](const char* a) { return std::string_view(a) == "--"; });
  if (split != end) {
    line.arguments.assign(split + 1, end);
  }
  line.words.assign(argv, split);
  try {
    app.parse(static_cast<int>(split - argv), argv);
  } catch (const CLI::Success& success) {  // --help, --version
    app.exit(success);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    refuse(app, error);
  }
  interpret(line, raw);
  return line;
}

}  // namespace rt::cli
