/// One picture of a session: from the job to the file, or to the checkpoint.
#include <fmt/format.h>

#include <algorithm>

#include "rt/cli/interrupt.h"
#include "rt/cli/output_path.h"
#include "rt/cli/progress.h"
#include "rt/cli/say.h"
#include "rt/cli/session.h"
#include "rt/io/image.h"
#include "rt/render/explain.h"
#include "rt/render/plan.h"
#include "rt/render/scene_warnings.h"
#include "rt/render/threads.h"

namespace rt::cli {

/// Where the next picture goes, numbered where it is one of an animation.
std::filesystem::path Session::place_of(const std::filesystem::path& by_script) const {
  const std::filesystem::path& by_user = line_.output;
  if (!frame_) {
    return output_path(by_script, by_user, of_frame_, line_.script.trust);
  }
  std::error_code ignored;
  const bool named = by_user.has_filename() && !std::filesystem::is_directory(by_user, ignored);
  return output_path(frame_path(by_script, *frame_), named ? frame_path(by_user, *frame_) : by_user,
                     of_frame_, line_.script.trust);
}

void Session::picture(RenderJob job) {
  const Busy busy;
  PictureReport report;
  report.phases.script = watch_.lap();
  override_options(job.options);
  report.crop = crop_of(job.options);
  if (line_.explain) {
    ++pictures_;
    fmt::print("{}", explain(make_plan(job), thread_count(line_.threads)));
    return;
  }
  const auto path = place_of(job.output);
  io::check_output(path, report.crop.width, report.crop.height);
  report.picture = path.string();
  report.options = job.options;
  if (interrupted()) {
    throw UserError(ExitCode::interrupted, "interrupted");
  }
  ++pictures_;
  ++of_frame_;
  if (keeper_.begin(path, job.options, report.crop)) {
    if (!line_.quiet) {
      say(fmt::format("{}: was finished before", report.picture));
    }
    return;
  }
  io::preload();
  report.instances = job.instances.size();
  report.lights = job.lights.size();

  const RenderPlan plan = make_plan(job);
  report.phases.plan = watch_.lap();
  Rendering rendering(plan, report.crop);
  keeper_.take_up(rendering, job);
  trace(rendering, job, report);
  RenderResult result = rendering.take();
  report.phases.trace_cpu = result.statistics.cpu_seconds;
  watch_.lap();
  report.phases.trace = rendering.seconds();
  report.statistics = result.statistics;
  const std::vector<std::string> warnings = scene_warnings(job, plan, result.film);
  report.reached = result.reached;
  if (page_.wanted()) {
    page_.picture(explain(plan, thread_count(line_.threads)), result);
    watch_.lap();  // no phase of the rendering
  }
  const Saved saved = write(report, std::move(result.film), {});
  report.phases.write = watch_.lap();
  std::ranges::for_each(warnings, warn);
  if (!saved.refusal.empty()) {
    misplaced_.emplace(fmt::format("{}. The picture is in {}", saved.refusal, saved.path.string()));
    throw *misplaced_;
  }
  tell(report);
  page_.finish(report);
  keeper_.finished();
  reports_.push_back(std::move(report));
}

/// Traces to the end; now and then a checkpoint is written, if that is asked for.
void Session::trace(Rendering& rendering, const RenderJob& job, const PictureReport& report) {
  using Clock = Deadline::Clock;
  ProgressReport progress(line_.progress, line_.quiet, report.picture, rendering.seconds());
  const ProgressFunction tell_progress = [&](const Progress& p) { progress(p); };
  Until until{.stop = &interrupted()};
  for (bool done = false, warned = false; !done;) {
    if (line_.checkpoint_every > 0.0) {
      until.pause = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                       std::chrono::duration<double>(line_.checkpoint_every));
    }
    done = rendering.run(tell_progress, until);
    if (!done && interrupted()) {
      leave_off(rendering, job, report);
    }
    if (!done) {
      try {
        keeper_.save(&rendering, &job);
      } catch (const FileError& error) {
        if (!std::exchange(warned, true)) {
          warn(error.what());
        }
      }
    }
  }
}

/// Saves what there is, and ends the session.
void Session::leave_off(Rendering& rendering, const RenderJob& job, const PictureReport& report) {
  const std::string checkpoint = keep(&rendering, &job);
  const double percent = 100.0 * rendering.fraction();
  RenderResult result = rendering.take();
  std::string picture = "nothing of it had been rendered";
  if (result.statistics.samples > 0) {
    try {
      const Saved saved = write(report, std::move(result.film),
                                {{"raytracer:unfinished", fmt::format("{:.1f}%", percent)}});
      picture = fmt::format("the picture so far is in {}{}", saved.path.string(),
                            saved.refusal.empty() ? "" : fmt::format(" ({})", saved.refusal));
    } catch (const FileError& error) {
      picture = error.what();
    }
  }
  saved_ = fmt::format("at {:.0f}% of {}; {}; {}", percent, report.picture, picture, checkpoint);
  throw UserError(ExitCode::interrupted, "interrupted");
}

/// Writes a last checkpoint and says where it is, or why there is none.
std::string Session::keep(const Rendering* rendering, const RenderJob* job) {
  try {
    const Saved saved = keeper_.save(rendering, job);
    return fmt::format("the checkpoint is in {}{}; to go on: {}", saved.path.string(),
                       saved.refusal.empty() ? "" : fmt::format(" ({})", saved.refusal),
                       keeper_.command(saved.path));
  } catch (const FileError& error) {
    return fmt::format("there is no checkpoint: {}", error.what());
  }
}

/// Writes the picture, elsewhere if it must be. `more` is added to its metadata.
Saved Session::write(const PictureReport& report, Film film,
                     const std::map<std::string, std::string>& more) const {
  std::map<std::string, std::string> texts = metadata(report.options);
  texts.insert(more.begin(), more.end());
  const io::Image image{film.width, film.height, std::move(film.pixels)};
  return save_somewhere(report.picture, [&](const std::filesystem::path& path) {
    io::write_image(path, image, report.options.encoding, texts);
  });
}

}  // namespace rt::cli
