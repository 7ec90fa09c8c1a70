#pragma once
#include <atomic>

namespace rt::cli {

/// From here on SIGINT, SIGTERM and SIGHUP (unless ignored, as below nohup) ask the program to save
/// what it has and to end. A script ends at its next instruction, or a second later the process; a
/// rendering (Busy) leaves off soon. A second signal ends the process at once. Exit code 130 in all
/// cases, and no half files. Also lets writing to a closed pipe, or beyond the limit on file sizes,
/// be an error rather than the end.
void watch_signals();

/// Whether a signal has asked for the end.
const std::atomic<bool>& interrupted();

/// While this lives the process is given the time it needs to end.
class Busy {
 public:
  Busy();
  ~Busy();
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  bool before_;
};

}  // namespace rt::cli
