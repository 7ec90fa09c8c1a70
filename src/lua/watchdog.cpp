#include "watchdog.h"

#include <pthread.h>
#include <signal.h>

#include <algorithm>
#include <cmath>

namespace rt::lua {

Watchdog::Watchdog(std::vector<Alarm> alarms) : alarms_(std::move(alarms)) {
  // Signals are the business of the threads that were there before.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { watch(); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Watchdog::pause() {
  const std::lock_guard lock(mutex_);
  before_ = seconds_locked();
  paused_ = true;
}

void Watchdog::resume() {
  {
    const std::lock_guard lock(mutex_);
    since_ = Clock::now();
    paused_ = false;
  }
  changed_.notify_one();
}

double Watchdog::seconds() const {
  const std::lock_guard lock(mutex_);
  return seconds_locked();
}

double Watchdog::seconds_locked() const {
  return paused_ ? before_ : before_ + std::chrono::duration<double>(Clock::now() - since_).count();
}

void Watchdog::watch() {
  std::unique_lock lock(mutex_);
  for (const Alarm& alarm : alarms_) {
    while (!ended_ && !(seconds_locked() >= alarm.seconds)) {
      if (paused_ || !std::isfinite(alarm.seconds)) {
        changed_.wait(lock);
      } else {
        // Capped: a wait of centuries overflows the clock.
        changed_.wait_for(
            lock, std::chrono::duration<double>(std::min(alarm.seconds - seconds_locked(), 1e6)));
      }
    }
    if (ended_) {
      return;
    }
    alarm.call();
  }
}

}  // namespace rt::lua
