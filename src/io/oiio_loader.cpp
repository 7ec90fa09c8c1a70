#include "oiio_loader.h"

#include <dlfcn.h>

#include <atomic>
#include <filesystem>
#include <future>
#include <system_error>
#include <vector>

#include "rt/scene/error.h"

namespace rt::io {
namespace {

/// Where the module may be: beside the program, where it was built, where it would be installed.
std::vector<std::filesystem::path> candidates() {
  std::vector<std::filesystem::path> folders;
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) {
    folders.push_back(program.parent_path());
  }
  folders.emplace_back(RT_BUILD_DIR);
  if (!program.empty()) {
    folders.push_back(program.parent_path().parent_path() / "lib" / "raytracer");
  }
  return folders;
}

const OiioTable* load() {
  std::string reason = "rt_oiio.so is neither beside the program nor in " RT_BUILD_DIR;
  for (const auto& folder : candidates()) {
    const auto file = folder / "rt_oiio.so";
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) {
      continue;
    }
    // Never closed: OpenImageIO does not survive being unloaded. Lazily: of the symbols of its two
    // hundred libraries few are ever used, and looking for all takes 16 ms.
    void* module = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* table = module != nullptr ? dlsym(module, oiio_table_symbol) : nullptr;
    if (table != nullptr) {
      return static_cast<const OiioTable*>(table);
    }
    const char* error = dlerror();
    reason = error != nullptr ? error : "no reason given";
    break;
  }
  throw FileError("cannot load the picture formats: " + reason + "; run ./bootstrap again");
}

std::atomic<bool> begun = false;

/// One loading a process.
const std::shared_future<const OiioTable*>& loading() {
  static const std::shared_future<const OiioTable*> future = [] {
    try {
      auto promised = std::async(std::launch::async, load).share();
      begun = true;
      return promised;
    } catch (const std::system_error&) {  // no thread to be had: load when the table is needed
      return std::async(std::launch::deferred, load).share();
    }
  }();
  return future;
}

}  // namespace

void begin_loading_oiio() { loading(); }

void end_loading_oiio() {
  if (begun) {
    loading().wait();
  }
}

const OiioTable& oiio() { return *loading().get(); }

}  // namespace rt::io
