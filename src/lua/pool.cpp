#include "pool.h"

#include <sys/mman.h>
#include <unistd.h>

#include <new>

namespace rt::lua {

Pool::Pool(MemoryMeter& meter) : meter_(meter) {}

void* Pool::take_fresh(Page*& first, std::size_t block_class, bool must) {
  const std::size_t bytes = (block_class + 1) * granule;
  const auto has_fresh = [bytes](Page& page) {
    return page.fresh + bytes <= reinterpret_cast<std::byte*>(&page) + page_bytes;
  };
  while (first != nullptr && first->returned == nullptr && !has_fresh(*first)) {
    Page& full = *first;
    unlink(full);
    full.is_full = true;
  }
  if (first == nullptr && new_page(block_class, must) == nullptr) {
    return nullptr;
  }
  if (first->returned != nullptr) {
    return take(bytes, must);
  }
  void* const block = first->fresh;
  first->fresh += bytes;
  ++first->in_use;
  return block;
}

Pool::Page* Pool::new_page(std::size_t block_class, bool must) {
  if ((!must && page_bytes > meter_.left()) || (spare_ == nullptr && !get_spare_pages())) {
    return nullptr;
  }
  Page* const page = spare_;
  spare_ = page->after;
  meter_.lua_takes(page_bytes);
  *page = {.fresh = reinterpret_cast<std::byte*>(page + 1), .class_ = block_class};
  link(*page);
  return page;
}

bool Pool::get_spare_pages() {
  std::unique_ptr<void, Free> memory(std::aligned_alloc(page_bytes, page_bytes * pages_at_once));
  if (!memory) {
    return false;
  }
  auto* const begin = static_cast<std::byte*>(memory.get());
  try {
    memory_.push_back(std::move(memory));
  } catch (const std::bad_alloc&) {  // Lua's allocator must not throw
    return false;
  }
  for (std::size_t i = pages_at_once; i-- > 0;) {
    spare_ = new (begin + i * page_bytes) Page{.after = spare_};
  }
  return true;
}

void Pool::give_back_to(Page& page) {
  if (page.is_full) {
    page.is_full = false;
    link(page);
  }
  const bool last_of_its_class = page.before == nullptr && page.after == nullptr;
  if (page.in_use > 0 || last_of_its_class) {
    return;
  }
  unlink(page);
  meter_.lua_gives_back(page_bytes);
  // All but the system's page that holds the list of spare ones.
  const auto kept = static_cast<std::size_t>(getpagesize());
  if (kept < page_bytes) {
    madvise(reinterpret_cast<std::byte*>(&page) + kept, page_bytes - kept, MADV_DONTNEED);
  }
  page.after = spare_;
  spare_ = &page;
}

void Pool::link(Page& page) {
  Page*& first = with_room_[page.class_];
  page.before = nullptr;
  page.after = first;
  if (first != nullptr) {
    first->before = &page;
  }
  first = &page;
}

void Pool::unlink(Page& page) {
  (page.before != nullptr ? page.before->after : with_room_[page.class_]) = page.after;
  if (page.after != nullptr) {
    page.after->before = page.before;
  }
}

}  // namespace rt::lua
