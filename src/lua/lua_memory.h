#pragma once
#include <cstddef>
#include <functional>
#include <utility>

#include "memory.h"
#include "pool.h"

namespace rt::lua {

/// A Lua state's memory: lua_newstate(LuaMemory::allocate, &memory). Where the meter refuses, Lua
/// collects its garbage and, when that is not enough, raises "not enough memory".
class LuaMemory {
 public:
  /// `on_refusal` is called whenever Lua is refused memory.
  LuaMemory(MemoryMeter& meter, std::function<void()> on_refusal)
      : meter_(meter), pool_(meter), on_refusal_(std::move(on_refusal)) {}

  /// As lua_Alloc says: frees when `size` is 0; `old_size` is a type's tag when `block` is null.
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t size) {
    auto& memory = *static_cast<LuaMemory*>(self);
    if (size == 0) {
      if (block != nullptr) {
        memory.give_back(block, old_size);
      }
      return nullptr;
    }
    return block == nullptr ? memory.take(size) : memory.resize(block, old_size, size);
  }

 private:
  void* take(std::size_t size) {
    if (size > Pool::largest) {
      return large(nullptr, 0, size);
    }
    void* const block = pool_.take(size, false);
    return block != nullptr ? block : refuse();
  }
  void give_back(void* block, std::size_t size) {
    if (size > Pool::largest) {
      large(block, size, 0);
    } else {
      pool_.give_back(block);
    }
  }
  void* resize(void* block, std::size_t old_size, std::size_t size);
  /// A block of the system's, made, changed or freed as by LuaMemory::allocate.
  void* large(void* block, std::size_t old_size, std::size_t size);
  void* refuse() const;

  MemoryMeter& meter_;
  Pool pool_;
  std::function<void()> on_refusal_;
};

}  // namespace rt::lua
