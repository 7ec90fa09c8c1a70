// Compiled for the oldest x86-64: it runs before any code that needs more.
#include <unistd.h>

namespace {

__attribute__((constructor(101))) void require_x86_64_v3() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2")) {
    return;
  }
  static const char message[] =
      "raytracer: this processor is too old: x86-64-v3 (AVX2, FMA, BMI2) is needed. To build for "
      "an "
      "older one, replace -march=x86-64-v3 in CMakeLists.txt.\n";
  const auto ignored = write(STDERR_FILENO, message, sizeof message - 1);
  static_cast<void>(ignored);
  _exit(1);
}

}  // namespace
