#pragma once
/// Tables in the order in which they are used, so that what is needed together lies together.
#include <sys/mman.h>

#include <cstdint>
#include <vector>

namespace rt {

/// Asks for large pages under what a vector has reserved, where nothing has been written yet: what
/// is looked up here and there then needs fewer steps to be found (bench/NOTES.md). A hint: where
/// the system has none, nothing changes.
template <class T>
void prefer_large_pages(const std::vector<T>& reserved) {
  constexpr std::uintptr_t page = std::uintptr_t{1} << 21U;
  const auto begin = reinterpret_cast<std::uintptr_t>(reserved.data());
  const std::uintptr_t first = (begin + page - 1) / page * page;
  const std::uintptr_t end = (begin + reserved.capacity() * sizeof(T)) / page * page;
  if (first < end) {
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
  }
}

/// Renumbers a table's entries in the order in which they are used. each_use(visit) calls
/// visit(index) for every index that is kept of one, and visit changes it.
template <class T, class EachUse>
void arrange_table(std::vector<T>& table, EachUse&& each_use) {
  if (table.size() < 2) {
    return;
  }
  constexpr std::uint32_t none = ~0U;
  std::vector<std::uint32_t> renumbered(table.size(), none);
  std::vector<T> arranged;
  arranged.reserve(table.size());
  prefer_large_pages(arranged);
  each_use([&](std::uint32_t& index) {
    std::uint32_t& to = renumbered[index];
    if (to == none) {
      to = static_cast<std::uint32_t>(arranged.size());
      arranged.push_back(std::move(table[index]));
    }
    index = to;
  });
  table = std::move(arranged);
}

}  // namespace rt
