#pragma once
#include <functional>

namespace rt {

/// How many threads that is: `threads`, or for 0 one a processor that this process may run on.
int thread_count(int threads);

/// Runs `work` with so many threads at its disposal (0: one a processor): what it builds and
/// renders uses no more, and that many even on a machine with fewer processors.
void with_threads(int threads, const std::function<void()>& work);

}  // namespace rt
