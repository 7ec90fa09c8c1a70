#pragma once
#include <chrono>
#include <string>

#include "rt/cli/command_line.h"
#include "rt/render/render.h"

namespace rt::cli {

/// Tells on standard error how far a rendering is: a bar on a terminal, plain lines or JSON
/// elsewhere. Speaks at most ten times a second (plain: every tenth of the picture).
class ProgressReport {
 public:
  /// `seconds_before`: that the picture took in the runs which it goes on from.
  ProgressReport(ProgressStyle style, bool quiet, std::string picture, double seconds_before = 0.0);
  /// Ends the bar's line, if one was begun.
  ~ProgressReport();
  ProgressReport(const ProgressReport&) = delete;
  ProgressReport& operator=(const ProgressReport&) = delete;

  void operator()(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;
  void bar(const Progress& progress, double seconds);

  enum class Form { none, bar, plain, json } form_;
  std::string picture_;
  Clock::time_point start_;  ///< as if earlier runs had ended just now
  Clock::time_point last_ = Clock::now();
  int tenths_ = 0;
  bool drawn_ = false;
};

}  // namespace rt::cli
