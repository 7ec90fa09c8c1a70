/// Renders a script's first picture on this thread and throws it away, so that what tracing costs
/// can be counted without the libraries that write pictures:
///
///   render_only SCENE.lua WIDTHxHEIGHT [OPTION=VALUE]... [FEATURE=off]... [-- ARGUMENT...]
///
/// On stdout a digest of the pixels, which says whether two ways of rendering gave the same
/// picture; processor seconds of compiling the scene and of tracing; the number of rays.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <string>

#include "rt/lua/script.h"
#include "rt/render/plan.h"
#include "rt/render/render.h"
#include "rt/render/threads.h"

namespace rt {
namespace {

RenderJob first_job(const char* script, const std::vector<std::string>& arguments) {
  std::optional<RenderJob> job;
  const lua::Host host{.render =
                           [&](RenderJob j) {
                             if (!job) {
                               job = std::move(j);
                             }
                           },
                       .warn = [](const std::string&) {}};
  lua::run_script(script, arguments, host);
  return std::move(*job);
}

void set(RenderOptions& options, const std::string& word) {
  const auto equals = word.find('=');
  const OptionSpec* spec = find_option(word.substr(0, equals));
  if (spec == nullptr || equals == std::string::npos) {
    throw std::invalid_argument("no option " + word);
  }
  const std::string text = word.substr(equals + 1);
  spec->set(options, text == "off" ? OptionValue(false) : OptionValue(text));
}

std::uint64_t digest(const std::vector<float>& pixels) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  const auto* bytes = reinterpret_cast<const unsigned char*>(pixels.data());
  for (std::size_t i = 0; i < pixels.size() * sizeof(float); ++i) {
    hash = (hash ^ bytes[i]) * 0x100000001b3;
  }
  return hash;
}

}  // namespace

/// What is counted; outside the unnamed namespace, so that a profiler finds its name.
[[gnu::noinline]] RenderResult planned_and_traced(const RenderJob& job, std::clock_t& planned) {
  const RenderPlan plan = make_plan(job);
  planned = std::clock();
  return render(plan, {0, 0, job.options.width, job.options.height}, {});
}

}  // namespace rt

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 3, argv + argc);
  const auto split = std::find(words.begin(), words.end(), "--");
  rt::RenderJob job =
      rt::first_job(argv[1], {split == words.end() ? split : split + 1, words.end()});
  rt::parse_size(argv[2], job.options.width, job.options.height);
  std::for_each(words.begin(), split, [&](const auto& word) { rt::set(job.options, word); });
  rt::with_threads(1, [&] {
    const std::clock_t start = std::clock();
    std::clock_t planned = start;
    const rt::RenderResult result = rt::planned_and_traced(job, planned);
    const std::clock_t end = std::clock();
    fmt::print("{:016x} {:.6f} {:.6f} {}\n", rt::digest(result.film.pixels),
               static_cast<double>(planned - start) / CLOCKS_PER_SEC,
               static_cast<double>(end - planned) / CLOCKS_PER_SEC, result.statistics.rays.total());
  });
}
