/// A scene as older ray tracers of distributed rays take it, on the renderer's own scene, hits,
/// lights and lobes, so that only the arrangement of samples differs:
///
///   bench_nested SCENE.lua WIDTHxHEIGHT CAMERA NEST SPREAD FILE.pfm [OPTION=VALUE]...
///
/// CAMERA: samples of a pixel. NEST: samples of each decision below them. SPREAD: random, jittered,
/// stratified or nets (draws.h). On stdout processor seconds and the number of rays.
#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "common/job.h"
#include "nesting/tracer.h"
#include "rt/render/film.h"
#include "rt/render/threads.h"

namespace rt::bench {
namespace {

Spread spread_of(const std::string& name) {
  constexpr const char* names[] = {"random", "jittered", "stratified", "nets"};
  for (int i = 0; i < 4; ++i) {
    if (name == names[i]) {
      return static_cast<Spread>(i);
    }
  }
  throw std::invalid_argument("no spread " + name);
}

/// Portable float map: rows from the bottom.
void write(const Film& film, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  out << "PF\n" << film.width << ' ' << film.height << "\n-1.0\n";
  const auto row = 3 * static_cast<std::size_t>(film.width);
  for (int y = film.height; y-- > 0;) {
    out.write(reinterpret_cast<const char*>(&film.pixels[row * static_cast<std::size_t>(y)]),
              static_cast<std::streamsize>(row * sizeof(float)));
  }
}

void run(const RenderJob& job, const Nesting& nesting, const std::string& file) {
  const RenderPlan plan = make_plan(job);
  Film film(plan.options.width, plan.options.height);
  NestedTracer tracer(job, plan, nesting);
  const double begin = thread_seconds();
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      film.set(x, y, tracer.pixel(x, y));
    }
  }
  fmt::print("{:.6f} {}\n", thread_seconds() - begin, tracer.counts().total());
  write(film, file);
}

}  // namespace
}  // namespace rt::bench

int main(int argc, char** argv) try {
  if (argc < 7) {
    fmt::print(stderr,
               "usage: bench_nested SCENE.lua WxH CAMERA NEST SPREAD FILE.pfm [OPTION=VALUE]...\n");
    return 2;
  }
  rt::RenderJob job = rt::bench::first_job(argv[1]);
  rt::parse_size(argv[2], job.options.width, job.options.height);
  for (int i = 7; i < argc; ++i) {
    rt::bench::set(job.options, argv[i]);
  }
  rt::with_threads(1, [&] {
    rt::bench::run(job, {std::stoi(argv[3]), std::stoi(argv[4]), rt::bench::spread_of(argv[5])},
                   argv[6]);
  });
} catch (const std::exception& error) {
  fmt::print(stderr, "bench_nested: {}\n", error.what());
  return 1;
}
