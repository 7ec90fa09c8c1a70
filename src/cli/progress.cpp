#include "rt/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "rt/cli/say.h"

namespace rt::cli {

ProgressReport::ProgressReport(ProgressStyle style, bool quiet, std::string picture,
                               double seconds_before)
    : form_(Form::none),
      picture_(std::move(picture)),
      start_(Clock::now() - std::chrono::duration_cast<Clock::duration>(
                                std::chrono::duration<double>(seconds_before))) {
  if (quiet || style == ProgressStyle::none) {
    return;
  }
  if (style == ProgressStyle::json) {
    form_ = Form::json;
  } else {
    const bool terminal = style == ProgressStyle::automatic && isatty(STDERR_FILENO) == 1;
    form_ = terminal ? Form::bar : Form::plain;
  }
}

ProgressReport::~ProgressReport() {
  if (drawn_) {
    std::fputs("\r\033[K", stderr);
  }
}

void ProgressReport::bar(const Progress& progress, double seconds) {
  constexpr int width = 30;
  const int filled = static_cast<int>(progress.fraction * width);
  const std::string text =
      fmt::format("\r{} [{:#<{}}{:.<{}}] {:3.0f}%  {:.1f} M rays/s  {:.0f} s left\033[K", picture_,
                  "", filled, "", width - filled, 100.0 * progress.fraction,
                  static_cast<double>(progress.rays) / seconds / 1e6,
                  seconds * (1.0 - progress.fraction) / progress.fraction);
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

void ProgressReport::operator()(const Progress& progress) {
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const bool due = now - last_ >= std::chrono::milliseconds(100);
  if (form_ == Form::plain) {
    const int tenths = static_cast<int>(progress.fraction * 10.0);
    if (due && tenths > tenths_ && tenths < 10) {
      tenths_ = tenths;
      last_ = now;
      say(fmt::format("{}: {}0%, {:.1f} s", picture_, tenths, seconds));
    }
  } else if (due && form_ == Form::json) {
    last_ = now;
    say(fmt::format("{{\"fraction\": {:.4f}, \"rays\": {}, \"seconds\": {:.2f}}}",
                    progress.fraction, progress.rays, seconds));
  } else if (due && form_ == Form::bar) {
    last_ = now;
    bar(progress, seconds);
  }
}

}  // namespace rt::cli
