// Starts the program that was compiled for the best this processor can do. Compiled for the oldest
// x86-64.
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string>

namespace {

struct Level {
  const char* name;
  const char* needs;
  bool supported;
};

int fail(const std::string& message) {
  std::fprintf(stderr, "raytracer: %s\n", message.c_str());
  return 1;
}

/// The file that is being run.
std::string own_path() {
  char path[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
  return length > 0 ? std::string(path, static_cast<std::size_t>(length)) : "raytracer";
}

}  // namespace

int main(int, char** argv) {
  __builtin_cpu_init();
  const Level levels[] = {
      {"v4", "AVX-512", __builtin_cpu_supports("x86-64-v4") != 0},
      {"v3", "AVX2, FMA, BMI2", __builtin_cpu_supports("x86-64-v3") != 0},
      {"v2", "SSE4.2", __builtin_cpu_supports("x86-64-v2") != 0},
  };
  const char* wanted = std::getenv("RT_CPU");
  for (const Level& level : levels) {
    const bool named = wanted != nullptr && std::strcmp(wanted, level.name) == 0;
    if (named && !level.supported) {
      return fail(std::string("RT_CPU asks for ") + level.name + ", but this processor lacks " +
                  level.needs);
    }
    if (named || (wanted == nullptr && level.supported)) {
      execv((own_path() + "-" + level.name).c_str(), argv);  // returns where that was not built
      if (named) {
        return fail(own_path() + "-" + level.name + " cannot be started: " + std::strerror(errno));
      }
    }
  }
  if (wanted != nullptr) {
    return fail(std::string("RT_CPU is '") + wanted + "'; expected v2, v3 or v4");
  }
  const bool too_old = std::none_of(std::begin(levels), std::end(levels),
                                    [](const Level& level) { return level.supported; });
  if (too_old) {
    return fail("this processor is too old: x86-64-v2 (SSE4.2) is needed");
  }
  return fail("none of " + own_path() + "-v2, -v3 and -v4 that this processor can run is there");
}
