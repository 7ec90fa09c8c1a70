/// Renders a script's first picture on this thread and throws it away, so that what tracing costs
/// can be counted without the libraries that write pictures:
///
///   render_only SCENE.lua WIDTHxHEIGHT [OPTION=VALUE]... [FEATURE=off]... [-- ARGUMENT...]
///
/// On stdout a digest of the pixels, which says whether two ways of rendering gave the same
/// picture; processor seconds of compiling the scene and of tracing; the number of rays; the number
/// of shapes, bytes allocated by the script and by the plan; processor seconds of the script.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "common/job.h"
#include "rt/render/plan.h"
#include "rt/render/render.h"
#include "rt/render/threads.h"

namespace rt {
namespace {

std::uint64_t digest(const std::vector<float>& pixels) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  const auto* bytes = reinterpret_cast<const unsigned char*>(pixels.data());
  for (std::size_t i = 0; i < pixels.size() * sizeof(float); ++i) {
    hash = (hash ^ bytes[i]) * 0x100000001b3;
  }
  return hash;
}

}  // namespace

struct Cost {
  double planning = 0.0;  ///< processor seconds
  double tracing = 0.0;
  std::uint64_t bytes = 0;
};

/// What is counted; outside the unnamed namespace, so that a profiler finds its name.
[[gnu::noinline]] RenderResult planned_and_traced(const RenderJob& job, Cost& cost) {
  // Asking what is allocated takes time of its own, up to half a second after a million shapes.
  const std::uint64_t before = bench::allocated();
  const double start = bench::thread_seconds();
  const RenderPlan plan = make_plan(job);
  cost.planning = bench::thread_seconds() - start;
  cost.bytes = bench::allocated() - before;
  const double planned = bench::thread_seconds();
  RenderResult result = render(plan, {0, 0, job.options.width, job.options.height}, {});
  cost.tracing = bench::thread_seconds() - planned;
  return result;
}

namespace {

void run(const std::string& scene, const std::string& size, const std::vector<std::string>& words) {
  const std::uint64_t empty = bench::allocated();
  const double begin = bench::thread_seconds();
  const auto split = std::find(words.begin(), words.end(), "--");
  RenderJob job = bench::first_job(scene, {split == words.end() ? split : split + 1, words.end()});
  const double scripted = bench::thread_seconds() - begin;
  const std::uint64_t script_bytes = bench::allocated() - empty;
  parse_size(size, job.options.width, job.options.height);
  std::for_each(words.begin(), split, [&](const auto& word) { bench::set(job.options, word); });
  with_threads(1, [&] {
    Cost cost;
    const RenderResult result = planned_and_traced(job, cost);
    fmt::print("{:016x} {:.6f} {:.6f} {} {} {} {} {:.6f}\n", digest(result.film.pixels),
               cost.planning, cost.tracing, result.statistics.rays.total(), job.instances.size(),
               script_bytes, cost.bytes, scripted);
  });
}

}  // namespace
}  // namespace rt

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: render_only SCENE.lua WIDTHxHEIGHT [OPTION=VALUE]... [-- ARG...]\n");
    return 2;
  }
  rt::run(argv[1], argv[2], {argv + 3, argv + argc});
}
