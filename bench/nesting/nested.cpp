/// A scene as older ray tracers of distributed rays take it: nested. Every camera sample is taken
/// at several times, every hit sends several rays to each light and several into its lobe, and so
/// on down: a tree of rays where the program follows one path a sample. On the renderer's own
/// scene, hits, lights and lobes, so that only the arrangement of samples differs.
///
///   bench_nested SCENE.lua WIDTHxHEIGHT CAMERA NEST random|spread FILE.pfm [OPTION=VALUE]...
///
/// CAMERA: samples over the pixel (a square number: one in each cell of a grid). NEST: how many at
/// each decision. random: all of them independent; spread: those of one decision well spread among
/// each other. On stdout processor seconds and rays. Without textures, glass, lenses and moving
/// cameras, which it refuses.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

#include "common/job.h"
#include "rt/math/fresnel.h"
#include "rt/render/direct_light.h"
#include "rt/render/query.h"
#include "rt/render/render.h"
#include "rt/render/threads.h"

namespace rt::bench {
namespace {

struct Nesting {
  int camera = 1;
  int nest = 1;
  bool spread = false;
};

/// The samples of one decision.
class Draws {
 public:
  Draws(bool spread, std::uint64_t set) : spread_(spread), set_(set) {}
  Sampler operator()(int i) const {
    const Sampler first(set_, spread_ ? 0 : i, 0, 0);
    return spread_ ? first.at(static_cast<std::uint32_t>(i)) : first;
  }

 private:
  bool spread_;
  std::uint64_t set_;
};

class NestedTracer {
 public:
  NestedTracer(const RenderPlan& plan, const Nesting& nesting)
      : plan_(plan), nesting_(nesting), cache_(plan) {}

  Rgb pixel(int x, int y) {
    const int side = static_cast<int>(std::lround(std::sqrt(nesting_.camera)));
    const int times = plan_.moves ? nesting_.nest : 1;
    Rgb sum(0.0);
    for (int cell = 0; cell < side * side; ++cell) {
      const Vec2 at = Sampler(next_set(), 0, 0, 0).pixel();
      const Vec2 p((x + (cell % side + at.x) / side) / plan_.options.width,
                   (y + (cell / side + at.y) / side) / plan_.options.height);
      const Draws draws = decide();
      for (int i = 0; i < times; ++i) {
        TraceRay ray{Vec3(0.0), glm::normalize(plan_.camera.direction(p.x, p.y))};
        ray.time = plan_.moves ? draws(i).time() : 0.0;
        ++counts_.camera;
        sum += radiance(ray, p.y, 0);
      }
    }
    return sum / static_cast<double>(side * side * times);
  }

  const RayCounts& counts() const { return counts_; }

 private:
  std::uint64_t next_set() { return ++sets_; }
  Draws decide() { return {nesting_.spread, next_set()}; }

  Rgb radiance(const TraceRay& ray, double y, int depth) {
    const auto hit = closest_hit(plan_, ray);
    if (!hit) {
      return glm::mix(plan_.options.background.top, plan_.options.background.bottom, y);
    }
    const ShadingPoint point = shading_point(plan_, ray, *hit);
    const PlannedMaterial& material = plan_.materials[plan_.instances[hit->instance].material];
    Rgb sum = material.emission + material.plain.kd * plan_.ambient;
    for (std::size_t i = 0; i < plan_.lights.size(); ++i) {
      sum += lit(i, point, material, ray.direction);
    }
    if (depth < plan_.options.max_depth && max_abs(material.reflectivity) > 0.0) {
      sum += material.reflectivity * reflected(point, material, ray.direction, y, depth);
    }
    return sum;
  }

  Rgb lit(std::size_t light, const ShadingPoint& point, const PlannedMaterial& material,
          const Vec3& direction) {
    const Phong phong{material.plain.kd, material.plain.ks, material.shininess,
                      material.least_r_dot_v};
    const bool point_like = !plan_.lights[light].rectangle && plan_.lights[light].radius == 0.0;
    const int count = point_like ? 1 : nesting_.nest;
    const Draws draws = decide();
    Rgb sum(0.0);
    for (int i = 0; i < count; ++i) {
      sum += direct_light(plan_, light, phong, point, -direction, draws(i), {},
                          negligible_light(plan_.options, plan_.lights.size()), cache_, counts_);
    }
    return sum / static_cast<double>(count);
  }

  Rgb reflected(const ShadingPoint& point, const PlannedMaterial& material, const Vec3& direction,
                double y, int depth) {
    const Vec3 mirror = reflect(direction, point.normal);
    const int count = material.lobe ? nesting_.nest : 1;
    const Draws draws = decide();
    Rgb sum(0.0);
    for (int i = 0; i < count; ++i) {
      PowerCosineLobe::Sample s{mirror, 1.0};
      if (material.lobe) {
        s = material.lobe->sample(draws(i).lobe(), mirror, point.normal);
      }
      ++counts_.reflection;
      sum += s.weight * radiance(leave(point, s.direction), y, depth + 1);
    }
    return sum / static_cast<double>(count);
  }

  const RenderPlan& plan_;
  Nesting nesting_;
  ShadowCache cache_;
  RayCounts counts_;
  std::uint64_t sets_ = 0;
};

void refuse_what_is_not_nested(const RenderPlan& plan) {
  bool refused = plan.moving_camera || plan.camera.lens_radius > 0.0 || plan.absorbs;
  for (const PlannedInstance& instance : plan.instances) {
    refused = refused || instance.textures || plan.materials[instance.material].transmissive;
  }
  if (refused) {
    throw std::invalid_argument("no textures, glass, lenses or moving cameras");
  }
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

void run(const RenderPlan& plan, const Nesting& nesting, const std::string& file) {
  refuse_what_is_not_nested(plan);
  Film film(plan.options.width, plan.options.height);
  NestedTracer tracer(plan, nesting);
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
               "usage: bench_nested SCENE.lua WxH CAMERA NEST random|spread FILE.pfm "
               "[OPTION=VALUE]...\n");
    return 2;
  }
  rt::RenderJob job = rt::bench::first_job(argv[1]);
  rt::parse_size(argv[2], job.options.width, job.options.height);
  for (int i = 7; i < argc; ++i) {
    rt::bench::set(job.options, argv[i]);
  }
  rt::with_threads(1, [&] {
    rt::bench::run(rt::make_plan(job),
                   {std::stoi(argv[3]), std::stoi(argv[4]), std::string(argv[5]) == "spread"},
                   argv[6]);
  });
} catch (const std::exception& error) {
  fmt::print(stderr, "bench_nested: {}\n", error.what());
  return 1;
}
