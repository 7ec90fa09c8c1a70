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
  double planned = 0.0;  ///< when the plan was made
  std::uint64_t bytes = 0;
};

/// What is counted; outside the unnamed namespace, so that a profiler finds its name.
[[gnu::noinline]] RenderResult planned_and_traced(const RenderJob& job, Cost& cost) {
  const std::uint64_t before = bench::allocated();
  const RenderPlan plan = make_plan(job);
  cost = {bench::thread_seconds(), bench::allocated() - before};
  return render(plan, {0, 0, job.options.width, job.options.height}, {});
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
    const double start = bench::thread_seconds();
    Cost cost;
    const RenderResult result = planned_and_traced(job, cost);
    fmt::print("{:016x} {:.6f} {:.6f} {} {} {} {} {:.6f}\n", digest(result.film.pixels),
               cost.planned - start, bench::thread_seconds() - cost.planned,
               result.statistics.rays.total(), job.instances.size(), script_bytes, cost.bytes,
               scripted);
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
