#pragma once
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rt/cli/command_line.h"
#include "rt/cli/html_report.h"
#include "rt/cli/keeper.h"
#include "rt/cli/report.h"
#include "rt/render/rendering.h"
#include "rt/scene/render_job.h"

namespace rt::cli {

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

/// Renders the pictures of one script.
class Session {
 public:
  explicit Session(const CommandLine& line) : line_(line), keeper_(line), page_(line.report) {}

  /// Throws UserError; with ExitCode::interrupted its text says what was saved where.
  void run();

 private:
  void run_scripts();
  void run_script(std::optional<int> frame);
  std::filesystem::path place_of(const std::filesystem::path& by_script) const;
  void override_options(RenderOptions& options) const;
  Crop crop_of(const RenderOptions& options) const;
  void picture(RenderJob job);
  void trace(Rendering& rendering, const RenderJob& job, const PictureReport& report);
  [[noreturn]] void leave_off(Rendering& rendering, const RenderJob& job,
                              const PictureReport& report);
  Saved write(const PictureReport& report, Film film,
              const std::map<std::string, std::string>& more) const;
  std::string keep(const Rendering* rendering, const RenderJob* job);
  std::map<std::string, std::string> metadata(const RenderOptions& options) const;
  void tell(const PictureReport& report) const;

  const CommandLine& line_;
  Keeper keeper_;
  HtmlReport page_;
  Stopwatch watch_;
  std::vector<PictureReport> reports_;
  std::size_t pictures_ = 0;            ///< that the script asked for
  std::optional<int> frame_;            ///< of which it is asking now
  std::size_t of_frame_ = 0;            ///< pictures that it asked for in this run
  std::optional<FileError> misplaced_;  ///< a picture could not be written where it should be
  std::string saved_;                   ///< what an interruption saved
};

}  // namespace rt::cli
