#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace rt::lua {

/// A thread that calls back when a stopwatch reaches given times. The stopwatch can be paused.
class Watchdog {
 public:
  struct Alarm {
    double seconds;              ///< on the stopwatch; infinite: never
    std::function<void()> call;  ///< on the watchdog's thread, which meanwhile holds its lock
  };

  /// Starts the stopwatch. The alarms are in the order of their times.
  explicit Watchdog(std::vector<Alarm> alarms);
  /// No alarm is called after this.
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  void pause();
  void resume();
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  void watch();
  double seconds_locked() const;

  std::vector<Alarm> alarms_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Clock::time_point since_ = Clock::now();
  double before_ = 0.0;
  bool paused_ = false;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace rt::lua
