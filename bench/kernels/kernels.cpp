/// The innermost pieces, by Google Benchmark: a shape's hit, noise, samples, filters, warps.
///
///   bench_kernels --benchmark_format=json
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "rt/geometry/shape.h"
#include "rt/math/filter.h"
#include "rt/math/lobe.h"
#include "rt/math/noise.h"
#include "rt/math/octaves.h"
#include "rt/math/sampler.h"
#include "rt/math/warp.h"

namespace rt::bench {
namespace {

constexpr std::size_t some = 4096;  // more than a branch predictor remembers, less than the cache

/// From a sphere about the shape, at points of its box made larger: some hit, some pass by.
std::vector<Ray> rays_at(const Bounds& box) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<> u(0.0, 1.0);
  std::vector<Ray> rays;
  while (rays.size() < some) {
    const Vec3 from =
        box.centre() + 3.0 * glm::length(box.extent()) * to_cone({u(engine), u(engine)}, {2.0});
    const double x = u(engine);
    const double y = u(engine);
    const Vec3 to = box.centre() + 1.4 * (Vec3(x, y, u(engine)) - 0.5) * box.extent();
    rays.push_back({from, glm::normalize(to - from)});
  }
  return rays;
}

template <class S>
void hits(benchmark::State& state, const S& shape, const Bounds& box) {
  const std::vector<Ray> rays = rays_at(box);
  std::size_t i = 0;
  std::size_t met = 0;
  for (auto _ : state) {
    const auto hit = intersect(shape, rays[i++ % some], INFINITY, {});
    met += hit ? 1 : 0;
    benchmark::DoNotOptimize(hit);
  }
  state.counters["hits"] = static_cast<double>(met) / static_cast<double>(state.iterations());
}

template <class S>
void add_shape(const char* name, const S& shape) {
  const Bounds own = bounds(shape);
  const Bounds box = own.finite() ? own : Bounds{Vec3(-1.0, -0.1, -1.0), Vec3(1.0, 0.1, 1.0)};
  benchmark::RegisterBenchmark((std::string("intersect/") + name).c_str(),
                               [=](benchmark::State& state) { hits(state, shape, box); });
}

/// A kernel of points in the unit cube.
template <class Kernel>
void add(const char* name, const Kernel& kernel) {
  benchmark::RegisterBenchmark(name, [=](benchmark::State& state) {
    std::mt19937_64 engine(2);
    std::uniform_real_distribution<> u(0.0, 1.0);
    std::vector<Vec3> points(some);
    for (Vec3& p : points) {
      p.x = u(engine);
      p.y = u(engine);
      p.z = u(engine);
    }
    std::uint32_t i = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(kernel(points[i % some], i));
      ++i;
    }
  });
}

void add_shapes() {
  add_shape("sphere", Sphere{});
  add_shape("box", Box{});
  add_shape("plane", Plane{});
  add_shape("square", Square{});
  add_shape("cylinder", Cylinder{});
  add_shape("cone", PointedCone{});
  add_shape("torus", Torus{});
  add_shape("blob", Blob{});
  MeshData one;
  one.positions = {{0, 0, 0}, {1, 0, 0.2}, {0, 1, 0.4}};
  one.triangles = {{0, 1, 2}};
  add_shape("triangle", Mesh{std::make_shared<const MeshData>(one)});
}

void add_noise() {
  add("noise/value",
      [noise = Noise(1)](const Vec3& p, std::uint32_t) { return noise.value(64.0 * p); });
  for (const int count : {1, 4, 16}) {
    std::vector<Octave> octaves;
    for (int i = 0; i < count; ++i) {
      octaves.push_back({std::ldexp(1.0, i), std::ldexp(1.0, -i)});
    }
    add(("noise/fbm_of_" + std::to_string(count)).c_str(),
        [noise = Noise(1), octaves](const Vec3& p, std::uint32_t) {
          return pattern_value(noise, NoiseKind::fbm, octaves, 8.0 * p, 0.0);
        });
  }
}

void add_sampling() {
  const auto sample = [](std::uint32_t i) { return Sampler(1, 2, 3, 0).at(i); };
  add("sampler/pixel", [=](const Vec3&, std::uint32_t i) { return sample(i).pixel(); });
  add("sampler/light", [=](const Vec3&, std::uint32_t i) { return sample(i).light(); });
  add("sampler/later_light",
      [=](const Vec3&, std::uint32_t i) { return sample(i).light({.order = 1, .copy = 0}); });
  add("sampler/time", [=](const Vec3&, std::uint32_t i) { return sample(i).time(); });
  for (const auto& [name, filter] : {std::pair{"filter/box", Filter::box},
                                     {"filter/tent", Filter::tent},
                                     {"filter/gaussian", Filter::gaussian},
                                     {"filter/blackman_harris", Filter::blackman_harris}}) {
    add(name, [f = filter](const Vec3& p, std::uint32_t) { return filter_offset(f, Vec2(p)); });
  }
  add("warp/disc", [](const Vec3& p, std::uint32_t) { return to_disc(Vec2(p)); });
  add("warp/sphere_light", [](const Vec3& p, std::uint32_t) {
    return sample_sphere(Vec2(p), Vec3(0.0, 0.0, 4.0 + p.z), Vec3(0.0), 1.0);
  });
  add("warp/lobe", [lobe = PowerCosineLobe(200.0)](const Vec3& p, std::uint32_t) {
    return lobe.sample(Vec2(p), {0.6, 0.0, 0.8}, {0.0, 0.0, 1.0});
  });
}

}  // namespace
}  // namespace rt::bench

int main(int argc, char** argv) {
  rt::bench::add_shapes();
  rt::bench::add_noise();
  rt::bench::add_sampling();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
}
