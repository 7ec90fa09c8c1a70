#include "common/job.h"

#include <malloc.h>
#include <time.h>

#include <optional>
#include <stdexcept>

#include "rt/lua/script.h"

namespace rt::bench {

RenderJob first_job(const std::string& script, const std::vector<std::string>& arguments) {
  std::optional<RenderJob> job;
  const lua::Host host{.render =
                           [&](RenderJob j) {
                             if (!job) {
                               job = std::move(j);
                             }
                           },
                       .warn = [](const std::string&) {}};
  lua::run_script(script, arguments, host);
  if (!job) {
    throw std::invalid_argument(script + " renders nothing");
  }
  return std::move(*job);
}

void set(RenderOptions& options, const std::string& word) {
  const auto equals = word.find('=');
  const OptionSpec* spec = find_option(word.substr(0, equals));
  if (spec == nullptr || equals == std::string::npos) {
    throw std::invalid_argument("no option " + word);
  }
  const std::string text = word.substr(equals + 1);
  spec->set(options, text == "off" ? OptionValue(false) : OptionValue(text));
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::uint64_t allocated() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace rt::bench
