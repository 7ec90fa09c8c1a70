#include "lua_memory.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace rt::lua {

void* LuaMemory::resize(void* block, std::size_t old_size, std::size_t size) {
  const bool was_large = old_size > Pool::largest;
  const bool is_large = size > Pool::largest;
  if (was_large && is_large) {
    return large(block, old_size, size);
  }
  if (!was_large && !is_large && Pool::class_of(old_size) == Pool::class_of(size)) {
    return block;
  }
  // Lua takes for granted that a block can be made smaller, at the limit too.
  void* const result = size <= old_size ? pool_.take(size, true) : take(size);
  if (result != nullptr) {
    std::memcpy(result, block, std::min(old_size, size));
    give_back(block, old_size);
  }
  return result;
}

void* LuaMemory::large(void* block, std::size_t old_size, std::size_t size) {
  if (size == 0) {
    std::free(block);
    meter_.lua_gives_back(old_size);
    return nullptr;
  }
  const bool fits = size <= old_size || size - old_size <= meter_.left();
  void* const result = fits ? std::realloc(block, size) : nullptr;
  if (result == nullptr) {
    return refuse();
  }
  meter_.lua_gives_back(old_size);
  meter_.lua_takes(size);
  return result;
}

void* LuaMemory::refuse() const {
  on_refusal_();
  return nullptr;
}

}  // namespace rt::lua
