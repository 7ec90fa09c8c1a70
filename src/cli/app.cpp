#include "rt/cli/app.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "rt/cli/output_path.h"
#include "rt/cli/progress.h"
#include "rt/cli/report.h"
#include "rt/cli/starter.h"
#include "rt/io/image.h"
#include "rt/io/obj.h"
#include "rt/io/texture.h"
#include "rt/lua/script.h"
#include "rt/render/plan.h"
#include "rt/render/scene_warnings.h"
#include "rt/render/threads.h"

namespace rt::cli {
namespace {

class Stopwatch {
 public:
  /// Seconds since the last call, or since the beginning.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// FNV-1a of the script's text: names the scene in a picture's metadata.
std::string hash_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::istreambuf_iterator<char> c(in), end; c != end; ++c) {
    hash = (hash ^ static_cast<unsigned char>(*c)) * 0x100000001b3;
  }
  return fmt::format("{:016x}", hash);
}

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

void warn(const std::string& text) { fmt::print(stderr, "warning: {}\n", text); }

/// Renders the pictures of one script.
class Session {
 public:
  explicit Session(const CommandLine& line) : line_(line) {}

  void run() {
    const auto render = [this](RenderJob job) {
      with_threads(line_.threads, [&] { picture(std::move(job)); });
    };
    const auto open_texture = [this](const std::filesystem::path& file) {
      return io::open_texture(file, line_.textures);
    };
    const lua::Host host{render, io::load_obj, open_texture, warn};
    lua::Settings settings = line_.script;
    settings.shipped_textures = shipped_textures();
    lua::run_script(line_.scene, line_.arguments, host, settings);
    if (reports_.empty()) {
      throw SceneError(fmt::format("{}: the script made no picture; it should call gr.render(...)",
                                   line_.scene.string()));
    }
    if (!line_.stats.empty()) {
      write_stats(line_.stats, line_.scene, thread_count(), io::texture_statistics(), reports_);
    }
  }

 private:
  int thread_count() const {
    return line_.threads > 0 ? line_.threads
                             : static_cast<int>(std::thread::hardware_concurrency());
  }

  /// The command line's options on top of the script's.
  void override_options(RenderOptions& options) const {
    if (line_.size) {
      std::tie(options.width, options.height) = *line_.size;
    }
    for (const auto& [spec, value] : line_.settings) {
      spec->set(options, value);
    }
  }

  Crop crop_of(const RenderOptions& options) const {
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

  void picture(RenderJob job) {
    PictureReport report;
    report.phases.script = watch_.lap();
    override_options(job.options);
    report.crop = crop_of(job.options);
    const auto path = output_path(job.output, line_.output, reports_.size(), line_.script.trust);
    io::check_output(path);
    io::preload();
    report.picture = path.string();
    report.options = job.options;
    report.instances = job.instances.size();
    report.lights = job.lights.size();

    const RenderPlan plan = make_plan(job);
    report.phases.plan = watch_.lap();
    RenderResult result = traced(plan, report);
    report.phases.trace_cpu = result.statistics.cpu_seconds;
    report.phases.trace = watch_.lap();
    report.statistics = result.statistics;
    const std::vector<std::string> warnings = scene_warnings(job, plan, result.film);
    report.reached = result.reached;
    io::write_image(path, {result.film.width, result.film.height, std::move(result.film.pixels)},
                    job.options.encoding, metadata(job.options));
    report.phases.write = watch_.lap();
    std::ranges::for_each(warnings, warn);
    tell(report);
    reports_.push_back(std::move(report));
  }

  RenderResult traced(const RenderPlan& plan, const PictureReport& report) const {
    ProgressReport progress(line_.progress, line_.quiet, report.picture);
    return render(plan, report.crop, [&](const Progress& p) { progress(p); });
  }

  std::map<std::string, std::string> metadata(const RenderOptions& options) const {
    std::string settings;
    for (const OptionSpec& spec : option_specs()) {
      std::visit([&](const auto& v) { settings += fmt::format("{}={} ", spec.name, v); },
                 spec.get(options));
    }
    settings.pop_back();
    return {{"Software", "raytracer " RT_VERSION},
            {"raytracer:scene", hash_of(line_.scene)},
            {"raytracer:settings", settings}};
  }

  void tell(const PictureReport& report) const {
    const RenderStatistics& s = report.statistics;
    if (s.bad_samples > 0) {
      warn(fmt::format(
          "{}: {} samples were not finite and were left out, the first in pixel ({}, {})",
          report.picture, s.bad_samples, s.first_bad_x, s.first_bad_y));
    }
    if (!line_.quiet) {
      fmt::print(stderr, "{}\n", summary(report));
    }
  }

  const CommandLine& line_;
  Stopwatch watch_;
  std::vector<PictureReport> reports_;
};

}  // namespace

void run(const CommandLine& line) { Session(line).run(); }

int main_program(int argc, const char* const* argv) {
  try {
    if (const auto line = parse_command_line(argc, argv)) {
      if (line->new_scene.empty()) {
        run(*line);
      } else {
        write_starter_scene(line->new_scene);
      }
    }
    return static_cast<int>(ExitCode::done);
  } catch (const UserError& error) {
    fmt::print(stderr, "error: {}\n", error.report());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "error: out of memory; make the scene or the picture smaller\n");
    return static_cast<int>(ExitCode::limit);
  }
}

}  // namespace rt::cli
