#include "guard.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "context.h"

namespace rt::lua {
namespace {

constexpr std::uint64_t counted_exactly = 200'000'000;
/// No machine runs more of them in a second.
constexpr double most_instructions_per_second = 1e9;
/// What a script gets, beyond its time, to come to its next instruction.
constexpr double grace_seconds = 1.0;
/// A measurement of speed takes so long.
constexpr double reckoning_seconds = 0.25;
/// Ignored unless somebody handles it, so that one that comes late does no harm.
constexpr int wake_up = SIGURG;

std::string time_text(double seconds) {
  return fmt::format(
      "the script has run longer than its limit of {:g} s; --script-time SECONDS raises it, "
      "--trust lifts every limit",
      seconds);
}

}  // namespace

std::atomic<Guard*> Guard::active_{nullptr};
std::atomic<pthread_t> Guard::active_thread_{};
std::atomic<bool> Guard::interrupted_{false};

void interrupt() { Guard::interrupt(); }

Guard::Guard(const Limits& limits, bool unlimited, std::string script)
    : limits_(limits),
      unlimited_(unlimited),
      script_(std::move(script)),
      // 1000 instructions take a microsecond or more, a call of the hook a twentieth of that.
      period_(static_cast<int>(std::clamp<std::uint64_t>(limits.instructions / 20, 1, 1000))) {}

Guard::~Guard() { end(); }

void Guard::begin(lua_State* L) {
  running_ = L;
  thread_ = pthread_self();
  active_thread_ = thread_;
  active_ = this;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigaction(wake_up, &action, nullptr);
  if (interrupted_) {
    arm(L);
  }
  if (unlimited_) {
    return;
  }

  std::vector<Watchdog::Alarm> alarms;
  const double count_from =
      0.5 * static_cast<double>(limits_.instructions) / most_instructions_per_second;
  if (limits_.instructions <= counted_exactly) {
    asked_ = counting;
    arm(L);
  } else if (count_from < limits_.seconds) {
    uncounted_for_ = count_from;
    alarms.push_back({count_from, [this] { ask(counting); }});
  }
  alarms.push_back({limits_.seconds, [this] { ask(stopping); }});
  alarms.push_back({limits_.seconds + grace_seconds, [this] { abandon(); }});
  watchdog_ = std::make_unique<Watchdog>(std::move(alarms));
}

void Guard::end() {
  watchdog_.reset();
  Guard* self = this;
  active_.compare_exchange_strong(self, nullptr);
}

Guard::Pause::Pause(Guard& guard) : watchdog_(guard.watchdog_.get()) {
  if (watchdog_ != nullptr) {
    watchdog_->pause();
  }
}

Guard::Pause::~Pause() {
  if (watchdog_ != nullptr) {
    watchdog_->resume();
  }
}

void Guard::on_signal(int) {
  const Guard* guard = active_;
  if (guard != nullptr && pthread_equal(pthread_self(), guard->thread_) != 0 &&
      (guard->asked_ != nothing || guard->should_stop())) {
    guard->arm(guard->running_);
  }
}

void Guard::interrupt() {
  interrupted_ = true;
  if (active_ != nullptr) {
    pthread_kill(active_thread_, wake_up);
  }
}

void Guard::arm(lua_State* L) const {
  lua_sethook(L, hook, LUA_MASKCOUNT, should_stop() ? 1 : period_);
}

void Guard::ask(Asked what) {
  asked_ = what;
  pthread_kill(thread_, wake_up);
}

void Guard::switch_to(lua_State* L) {
  running_ = L;
  if (should_stop() || (asked_ == counting && lua_gethook(L) == nullptr)) {
    arm(L);
  }
}

void Guard::count_new_coroutine(lua_State* L) {
  if (asked_ == counting) {
    count(L);
  }
}

void Guard::stop(lua_State* L, ExitCode code, const std::string& text) {
  if (!stopped_) {
    stopped_.emplace(code, text);
  }
  arm(L);
}

void Guard::hook(lua_State* L, lua_Debug*) { context(L).guard.on_hook(L); }

void Guard::on_hook(lua_State* L) {
  if (!stopped_) {
    if (interrupted_) {
      stop(L, ExitCode::interrupted, at_location(L, script_, "interrupted"));
    } else if (asked_ == stopping) {
      stop(L, ExitCode::limit, at_location(L, script_, time_text(limits_.seconds)));
    } else {
      count(L);
    }
  }
  if (stopped_) {
    arm(L);
    lua_pushstring(L, stopped_->what());
    lua_error(L);
  }
}

void Guard::count(lua_State* L) {
  counted_ += period_;
  reckon_uncounted();
  if (counted_ > static_cast<double>(limits_.instructions)) {
    stop(L, ExitCode::limit,
         at_location(L, script_,
                     fmt::format("the script has run more than its limit of {} instructions; "
                                 "--script-instructions N raises it, --trust lifts every limit",
                                 limits_.instructions)));
  }
}

void Guard::reckon_uncounted() {
  if (uncounted_for_ > 0.0) {
    const double counting_for = watchdog_->seconds() - uncounted_for_;
    if (counting_for >= reckoning_seconds) {
      counted_ += counted_ / counting_for * uncounted_for_;
      uncounted_for_ = 0.0;
    }
  }
}

void Guard::abandon() const {
  const std::string text = fmt::format(
      "error: {}: {}. It was inside one long call, such as gr.mesh of a large file or string.find "
      "with a pattern that tries too many ways\n",
      script_, time_text(limits_.seconds));
  // The script's thread may hold the lock of a stream.
  if (ftrylockfile(stdout) == 0) {
    std::fflush(stdout);
    funlockfile(stdout);
  }
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(static_cast<int>(ExitCode::limit));
}

}  // namespace rt::lua
