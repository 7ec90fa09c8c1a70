/// Renders a script's first picture on this thread and throws it away, so that what tracing costs
/// can be counted without the libraries that write pictures:
///
///   render_only SCENE.lua WIDTHxHEIGHT [OPTION=VALUE]... [FEATURE=off]...
///
/// A digest of the pixels on stdout says whether two ways of rendering gave the same picture.
#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "rt/lua/script.h"
#include "rt/render/plan.h"
#include "rt/render/render.h"
#include "rt/render/threads.h"

namespace rt {
namespace {

RenderJob first_job(const char* script) {
  std::optional<RenderJob> job;
  const lua::Host host{.render =
                           [&](RenderJob j) {
                             if (!job) {
                               job = std::move(j);
                             }
                           },
                       .warn = [](const std::string&) {}};
  lua::run_script(script, {}, host);
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
[[gnu::noinline]] RenderResult planned_and_traced(const RenderJob& job) {
  const RenderPlan plan = make_plan(job);
  return render(plan, {0, 0, job.options.width, job.options.height}, {});
}

}  // namespace rt

int main(int argc, char** argv) {
  rt::RenderJob job = rt::first_job(argv[1]);
  rt::parse_size(argv[2], job.options.width, job.options.height);
  for (int i = 3; i < argc; ++i) {
    rt::set(job.options, argv[i]);
  }
  rt::with_threads(
      1, [&] { fmt::print("{:016x}\n", rt::digest(rt::planned_and_traced(job).film.pixels)); });
}
