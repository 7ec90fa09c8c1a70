#include "rt/cli/session.h"

#include <fmt/format.h>

#include <system_error>
#include <tuple>

#include "rt/cli/identity.h"
#include "rt/cli/interrupt.h"
#include "rt/cli/say.h"
#include "rt/io/obj.h"
#include "rt/io/texture.h"
#include "rt/io/whole_file.h"
#include "rt/lua/script.h"
#include "rt/render/threads.h"

namespace rt::cli {
namespace {

/// Where the textures that come with the program are: installed, or in its sources.
std::filesystem::path shipped_textures() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto installed = program.parent_path().parent_path() / "share/raytracer/textures";
  for (const auto& folder : {installed, std::filesystem::path(RT_TEXTURE_DIR)}) {
    if (std::filesystem::is_directory(folder, error)) {
      return folder;
    }
  }
  return {};
}

}  // namespace

void Session::run() {
  if (!line_.stats.empty()) {
    io::check_place(line_.stats);
  }
  try {
    run_scripts();
  } catch (const UserError& error) {
    if (error.code() != ExitCode::interrupted) {
      throw;
    }
    const Busy busy;
    if (saved_.empty()) {  // the script was running
      saved_ = keeper_.has_finished() ? "between pictures; " + keep(nullptr, nullptr)
                                      : "nothing had been rendered";
    }
    throw UserError(ExitCode::interrupted, saved_);
  }
  if (misplaced_) {
    throw *misplaced_;  // the script has caught it
  }
  if (pictures_ == 0) {
    throw SceneError(fmt::format("{}: the script made no picture; it should call gr.render(...)",
                                 line_.scene.string()));
  }
  const Busy busy;
  if (!line_.stats.empty()) {
    write_stats(line_.stats, line_.scene, thread_count(line_.threads), io::texture_statistics(),
                reports_);
  }
  page_.write(line_.scene);
  keeper_.end();
}

void Session::run_scripts() {
  if (!line_.frames) {
    run_script({});
    return;
  }
  for (int frame = line_.frames->first; frame <= line_.frames->last; ++frame) {
    run_script(frame);
  }
}

void Session::run_script(std::optional<int> frame) {
  frame_ = frame;
  of_frame_ = 0;
  const auto render = [this](RenderJob job) {
    with_threads(line_.threads, [&] { picture(std::move(job)); });
  };
  const auto load_mesh = [this](const std::filesystem::path& file) {
    keeper_.reads(file);
    return io::load_obj(file);
  };
  const auto open_texture = [this](const std::filesystem::path& file) {
    keeper_.reads(file);
    return io::open_texture(file, line_.textures);
  };
  const auto reads = [this](const std::filesystem::path& file) { keeper_.reads(file); };
  const lua::Host host{render, load_mesh, open_texture, warn, reads};
  lua::Settings settings = line_.script;
  settings.shipped_textures = shipped_textures();
  settings.frame = frame;
  lua::run_script(line_.scene, line_.arguments, host, settings);
}

/// The command line's options on top of the script's.
void Session::override_options(RenderOptions& options) const {
  if (line_.size) {
    std::tie(options.width, options.height) = *line_.size;
  }
  for (const auto& [spec, value] : line_.settings) {
    spec->set(options, value);
  }
}

Crop Session::crop_of(const RenderOptions& options) const {
  if (!line_.crop) {
    return {0, 0, options.width, options.height};
  }
  const Crop& c = *line_.crop;
  if (c.width > options.width - c.x || c.height > options.height - c.y) {
    throw UsageError(fmt::format("--crop: {},{},{},{} reaches beyond the picture's {}x{} pixels",
                                 c.x, c.y, c.width, c.height, options.width, options.height));
  }
  return c;
}

std::map<std::string, std::string> Session::metadata(const RenderOptions& options) const {
  std::string settings;
  for (const OptionSpec& spec : option_specs()) {
    std::visit([&](const auto& v) { settings += fmt::format("{}={} ", spec.name, v); },
               spec.get(options));
  }
  settings.pop_back();
  return {{"Software", "raytracer " RT_VERSION},
          {"raytracer:scene", fmt::format("{:016x}", digest_of_file(line_.scene))},
          {"raytracer:settings", settings}};
}

void Session::tell(const PictureReport& report) const {
  const RenderStatistics& s = report.statistics;
  if (s.bad_samples > 0) {
    warn(
        fmt::format("{}: {} samples were not finite and were left out, the first in pixel ({}, {})",
                    report.picture, s.bad_samples, s.first_bad_x, s.first_bad_y));
  }
  if (!line_.quiet) {
    say(summary(report));
  }
}

}  // namespace rt::cli
