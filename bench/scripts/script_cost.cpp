/// Runs a script, for its costs to be counted without the rest of the program:
///
///   script_cost sandbox|trusted|plain SCRIPT.lua
///
/// As the program does, as it does with --trust, or in a Lua state as the library gives it, without
/// gr. At a script's first picture it prints how many shapes there are, the processor seconds they
/// took and the most memory that was held, in MB: from the program's start to where rendering
/// begins.
#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdlib>
#include <lua.hpp>
#include <string_view>

#include "rt/lua/script.h"
#include "rt/scene/error.h"

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

[[noreturn]] void report(const rt::RenderJob& job) {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  fmt::print("{} {:.3f} {}\n", job.instances.size(),
             seconds(used.ru_utime) + seconds(used.ru_stime), used.ru_maxrss >> 10);
  std::exit(0);
}

int run_plain(const char* script) {
  lua_State* L = luaL_newstate();
  luaL_openlibs(L);
  const bool failed = luaL_dofile(L, script);
  if (failed) {
    fmt::print(stderr, "{}\n", lua_tostring(L, -1));
  }
  lua_close(L);
  return failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view mode = argc == 3 ? argv[1] : "";
  if (mode == "plain") {
    return run_plain(argv[2]);
  }
  if (mode != "sandbox" && mode != "trusted") {
    fmt::print(stderr, "usage: script_cost sandbox|trusted|plain SCRIPT.lua\n");
    return 2;
  }
  // The limits are raised out of the way of a profiler, under which all takes fifty times as long.
  rt::lua::Settings settings;
  settings.trust = mode == "trusted";
  settings.limits.seconds *= 50;
  settings.limits.instructions *= 50;
  try {
    rt::lua::run_script(argv[2], {}, rt::lua::Host{.render = report}, settings);
  } catch (const rt::UserError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
