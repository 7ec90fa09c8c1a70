#include "rt/render/threads.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

namespace rt {

int thread_count(int threads) { return threads > 0 ? threads : tbb::info::default_concurrency(); }

void with_threads(int threads, const std::function<void()>& work) {
  const int count = thread_count(threads);
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(count));
  tbb::task_arena arena(count);
  arena.execute(work);
}

}  // namespace rt
