#include "rt/cli/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include "rt/io/whole_file.h"
#include "rt/lua/script.h"
#include "rt/scene/error.h"

namespace rt::cli {
namespace {

std::atomic<bool> asked{false};
std::atomic<bool> busy{false};
static_assert(std::atomic<bool>::is_always_lock_free, "for signal handlers");

/// What a script gets to come to its next instruction.
constexpr unsigned grace_seconds = 1;

void handle(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigfillset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

[[noreturn]] void end_now(int) {
  io::abandon_temporary();
  static const char text[] = "interrupted at once\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof text - 1);
  ::_exit(static_cast<int>(ExitCode::interrupted));
}

void ask(int number) {
  if (asked.exchange(true)) {
    end_now(number);
  }
  lua::interrupt();
  if (!busy) {
    ::alarm(grace_seconds);
  }
}

}  // namespace

void watch_signals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) {
      handle(number, ask);
    }
  }
  handle(SIGALRM, end_now);
  handle(SIGPIPE, SIG_IGN);
  handle(SIGXFSZ, SIG_IGN);
}

const std::atomic<bool>& interrupted() { return asked; }

Busy::Busy() : before_(busy.exchange(true)) { ::alarm(0); }

Busy::~Busy() {
  busy = before_;
  if (!before_ && asked) {
    ::alarm(grace_seconds);
  }
}

}  // namespace rt::cli
