/// Opens a shared library and ends: what loading it costs, of the whole process.
///
///   time_dlopen LIBRARY
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  if (argc != 2 || dlopen(argv[1], RTLD_NOW) == nullptr) {
    std::fprintf(stderr, "time_dlopen: %s\n", argc == 2 ? dlerror() : "usage: time_dlopen LIBRARY");
    return 1;
  }
  std::quick_exit(0);
}
