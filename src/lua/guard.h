#pragma once
#include <pthread.h>

#include <atomic>
#include <lua.hpp>
#include <memory>
#include <optional>
#include <string>

#include "rt/lua/script.h"
#include "rt/scene/error.h"
#include "watchdog.h"

namespace rt::lua {

/// Stops a script that takes too long.
///
/// Time: a watchdog thread signals the script's thread when the time is up, whose handler sets a
/// hook (what lua_sethook is documented for), which raises an error at the next instruction. A
/// script that is inside one long call, of a library function or of gr.mesh, comes to no next
/// instruction: a second later the watchdog ends the process.
///
/// Instructions: Lua counts them only with a hook set, and then runs a third slower. A limit below
/// `counted_exactly` is counted from the start. Above that the hook is set once the script has run
/// for as long as a fast machine needs for half of the limit; what was run before is reckoned by
/// the speed measured afterwards.
///
/// A stop is for good: after pcall has caught its error, the next instruction raises it again.
class Guard {
 public:
  /// Without limits nothing is watched.
  Guard(const Limits& limits, bool unlimited, std::string script);
  ~Guard();
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  /// Between these the calling thread runs the script in L.
  void begin(lua_State* L);
  void end();

  /// While this lives the time is not the script's.
  class Pause {
   public:
    explicit Pause(Guard& guard);
    ~Pause();
    Pause(const Pause&) = delete;
    Pause& operator=(const Pause&) = delete;

   private:
    Watchdog* watchdog_;
  };

  /// The state, or coroutine, that is running.
  lua_State* running() const { return running_; }
  /// To be called whenever another coroutine is going to run: each has a hook of its own.
  void switch_to(lua_State* L);
  /// A coroutine starts counting afresh: one that is short-lived would never be counted.
  void count_new_coroutine(lua_State* L);

  /// lua::interrupt().
  static void interrupt();

  /// Stops the script. The caller raises the error.
  void stop(lua_State* L, ExitCode code, const std::string& text);
  const std::optional<UserError>& stopped() const { return stopped_; }

 private:
  enum Asked : int { nothing, counting, stopping };
  static void hook(lua_State* L, lua_Debug*);
  static void on_signal(int);
  void arm(lua_State* L) const;
  bool should_stop() const { return asked_ == stopping || stopped_ || interrupted_; }
  void ask(Asked what);
  void on_hook(lua_State* L);
  void count(lua_State* L);
  void reckon_uncounted();
  [[noreturn]] void abandon() const;

  static std::atomic<Guard*> active_;
  /// The thread of the active guard; stays when it ends, so that a signal handler may use it.
  static std::atomic<pthread_t> active_thread_;
  static std::atomic<bool> interrupted_;

  const Limits limits_;
  const bool unlimited_;
  const std::string script_;
  int period_;
  std::atomic<lua_State*> running_{nullptr};
  std::atomic<int> asked_{nothing};
  pthread_t thread_{};
  double counted_ = 0.0;        ///< instructions
  double uncounted_for_ = 0.0;  ///< seconds before counting began; 0: there were none, or reckoned
  std::optional<UserError> stopped_;
  std::unique_ptr<Watchdog> watchdog_;
};

}  // namespace rt::lua
