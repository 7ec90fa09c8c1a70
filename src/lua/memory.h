#pragma once
#include <cstddef>
#include <cstdlib>

namespace rt::lua {

/// Counts what a Lua state allocates and refuses what goes over the limit. Lua then collects its
/// garbage and, when that is not enough, raises "not enough memory".
struct MemoryMeter {
  std::size_t limit;
  std::size_t used = 0;
  bool refused = false;

  /// Lua's allocator: lua_newstate(MemoryMeter::allocate, &meter).
  static void* allocate(void* meter, void* block, std::size_t old_size, std::size_t new_size) {
    auto& self = *static_cast<MemoryMeter*>(meter);
    const std::size_t before = block == nullptr ? 0 : old_size;  // else old_size is a type tag
    if (new_size == 0) {
      std::free(block);
      self.used -= before;
      return nullptr;
    }
    const bool fits = new_size <= before || new_size - before <= self.limit - self.used;
    void* result = fits ? std::realloc(block, new_size) : nullptr;
    if (result == nullptr) {
      self.refused = true;
      return nullptr;
    }
    self.used = self.used - before + new_size;
    return result;
  }
};

}  // namespace rt::lua
