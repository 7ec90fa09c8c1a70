/// The memory of Lua's objects: blocks as its allocator must give them, and what the meter counts.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <random>
#include <vector>

#include "lua_memory.h"

namespace rt::lua {
namespace {

constexpr std::size_t kMegabyte = 1 << 20;
/// A page of each kind of block is kept.
constexpr std::size_t kKept = kMegabyte;

class Memory : public testing::Test {
 protected:
  void* allocate(void* block, std::size_t old_size, std::size_t size) {
    return LuaMemory::allocate(&memory_, block, old_size, size);
  }
  std::vector<void*> fill(std::size_t size) {
    std::vector<void*> blocks;
    while (void* block = allocate(nullptr, 0, size)) {
      blocks.push_back(block);
    }
    return blocks;
  }
  void free_all(const std::vector<void*>& blocks, std::size_t size) {
    for (void* block : blocks) {
      allocate(block, size, 0);
    }
  }

  MemoryMeter meter_{40 * kMegabyte};
  int refusals_ = 0;
  LuaMemory memory_{meter_, [this] { ++refusals_; }};
};

TEST_F(Memory, BlocksKeepTheirBytes) {
  struct Owned {
    unsigned char* data;
    std::size_t size;
    unsigned char value;
  };
  std::vector<Owned> blocks;
  std::mt19937 random(1);
  const auto check = [](const Owned& block, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      ASSERT_EQ(block.data[i], block.value) << i << " of " << block.size;
    }
  };
  for (int i = 0; i < 200'000; ++i) {
    const std::size_t size = 1 + random() % (random() % 16 == 0 ? 3000 : 300);
    const std::size_t at = blocks.empty() ? 0 : random() % blocks.size();
    if (blocks.size() < 5000 && random() % 2 == 0) {
      blocks.push_back({nullptr, 0, 0});
      blocks.back().data = static_cast<unsigned char*>(allocate(nullptr, 5, size));
    } else if (blocks.empty()) {
      continue;
    } else if (random() % 2 == 0) {
      check(blocks[at], blocks[at].size);
      allocate(blocks[at].data, blocks[at].size, 0);
      blocks[at] = blocks.back();
      blocks.pop_back();
      continue;
    } else {
      std::swap(blocks[at], blocks.back());
      Owned& block = blocks.back();
      block.data = static_cast<unsigned char*>(allocate(block.data, block.size, size));
      check(block, std::min(block.size, size));
    }
    Owned& block = blocks.back();
    ASSERT_NE(block.data, nullptr);
    ASSERT_EQ(reinterpret_cast<std::uintptr_t>(block.data) % alignof(std::max_align_t), 0u);
    block.size = size;
    block.value = static_cast<unsigned char>(random());
    std::memset(block.data, block.value, size);
  }
  EXPECT_LT(meter_.left(), meter_.limit() - kMegabyte);
  for (const Owned& block : blocks) {
    check(block, block.size);
    allocate(block.data, block.size, 0);
  }
  EXPECT_GT(meter_.left(), meter_.limit() - kKept);
  EXPECT_EQ(refusals_, 0);
}

TEST_F(Memory, HoldsNoMoreThanTheLimit) {
  for (const std::size_t size : {1u, 16u, 40u, 200u, 256u, 257u, 5000u}) {
    const int before = refusals_;
    const std::vector<void*> blocks = fill(size);
    EXPECT_LE(blocks.size() * size, meter_.limit()) << size;
    // What Lua asks for is rounded up to 16 bytes; of a page little is lost.
    EXPECT_GT(blocks.size() * ((size + 15) / 16 * 16), meter_.limit() - 2 * kMegabyte) << size;
    EXPECT_EQ(refusals_, before + 1);
    free_all(blocks, size);
  }
}

TEST_F(Memory, CanAlwaysBeMadeSmaller) {
  std::vector<void*> blocks = fill(1000);
  const std::vector<void*> rest = fill(48);
  for (std::size_t i = 0; i < 100; ++i) {
    blocks[i] = allocate(blocks[i], 1000, 1 + i);
    ASSERT_NE(blocks[i], nullptr);
    allocate(blocks[i], 1 + i, 0);
  }
  free_all({blocks.begin() + 100, blocks.end()}, 1000);
  free_all(rest, 48);
  EXPECT_GT(meter_.left(), meter_.limit() - kKept);
}

std::size_t resident_bytes() {
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(getpagesize());
}

TEST_F(Memory, OfFreedBlocksGoesBackToTheSystem) {
  const std::vector<void*> blocks = fill(64);
  for (void* block : blocks) {
    std::memset(block, 1, 64);
  }
  const std::size_t full = resident_bytes();
  free_all(blocks, 64);
  // Of each 32 KB one page of 4 KB stays.
  EXPECT_LT(resident_bytes() + 30 * kMegabyte, full);
}

}  // namespace
}  // namespace rt::lua
