#pragma once
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace rt {

#if defined(__SANITIZE_THREAD__)
// ThreadSanitizer cannot see what oneTBB synchronises. Threads that it understands take indices
// from a counter, so that it finds the races of our own code and no others.
template <class Work>
void for_each_index(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> threads;
  for (int i = 0; i < tbb::this_task_arena::max_concurrency(); ++i) {
    threads.emplace_back([&] {
      for (std::size_t index = next++; index < count; index = next++) {
        work(index);
      }
    });
  }
}
#else
/// work(i) for i from 0 to count - 1, on the threads of the arena that this is called in.
template <class Work>
void for_each_index(std::size_t count, const Work& work) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          work(i);
        }
      },
      tbb::simple_partitioner());
}
#endif

}  // namespace rt
