#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "memory.h"

namespace rt::lua {

/// Small blocks of memory for one Lua state, which makes and drops them by the million: a third of
/// the time of a script that makes objects would go into malloc. A page holds blocks of one size
/// and is found from a block's address; pages are what the meter counts. A page whose blocks have
/// all been given back goes back to the meter, and its memory to the system.
class Pool {
 public:
  /// Bytes of the largest block it gives out.
  static constexpr std::size_t largest = 256;

  explicit Pool(MemoryMeter& meter);
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// A block of `bytes`, from 1 to `largest`. Null where the meter refuses one page more, unless
  /// the block `must` be, or the system has none.
  void* take(std::size_t bytes, bool must) {
    Page*& first = with_room_[class_of(bytes)];
    if (first == nullptr || first->returned == nullptr) {
      return take_fresh(first, class_of(bytes), must);
    }
    Block* const block = first->returned;
    first->returned = block->next;
    ++first->in_use;
    return block;
  }

  void give_back(void* address) {
    Page& page = page_of(address);
    page.returned = new (address) Block{page.returned};
    if (--page.in_use == 0 || page.is_full) {
      give_back_to(page);
    }
  }

  /// Blocks of so many bytes are alike.
  static std::size_t class_of(std::size_t bytes) { return (bytes - 1) / granule; }

 private:
  static constexpr std::size_t granule = alignof(std::max_align_t);
  static constexpr std::size_t page_bytes = 32 << 10;
  static constexpr std::size_t pages_at_once = 32;

  struct Block {
    Block* next;
  };
  struct alignas(std::max_align_t) Page {
    Block* returned = nullptr;   ///< blocks that were given back
    std::byte* fresh = nullptr;  ///< from here to the page's end none has been given out
    std::size_t class_ = 0;
    std::uint32_t in_use = 0;
    bool is_full = false;  ///< then it is not in the list of those with room
    Page* before = nullptr;
    Page* after = nullptr;
  };
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };

  static Page& page_of(void* address) {
    return *reinterpret_cast<Page*>(reinterpret_cast<std::uintptr_t>(address) & ~(page_bytes - 1));
  }
  void* take_fresh(Page*& first, std::size_t block_class, bool must);
  Page* new_page(std::size_t block_class, bool must);
  bool get_spare_pages();
  void give_back_to(Page& page);
  void link(Page& page);
  void unlink(Page& page);

  MemoryMeter& meter_;
  Page* with_room_[largest / granule] = {};
  Page* spare_ = nullptr;
  std::vector<std::unique_ptr<void, Free>> memory_;
};

}  // namespace rt::lua
