#pragma once
#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace rt::bench {

/// Calls task(0) .. task(count - 1) on `threads` threads, each when one is free.
inline void in_parallel(std::size_t count, int threads,
                        const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> pool;
  for (int i = 0; i < threads; ++i) {
    pool.emplace_back([&] {
      for (std::size_t k = next++; k < count; k = next++) {
        task(k);
      }
    });
  }
}

}  // namespace rt::bench
