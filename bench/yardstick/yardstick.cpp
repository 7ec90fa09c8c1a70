/// The price of generality: the renderer against loops that can do nothing else than one ball under
/// one point of light, in turns on one thread, as CSV:
///
///   bench_yardstick SCENE.lua WIDTHxHEIGHT ROUNDS
///
/// All work in double precision, one ray through each pixel's centre, and fill a film of floats.
/// *least*: a loop whose author has thought: a ball cannot shade what of it faces the light, and
/// highlights too faint to be seen are left out, as the renderer leaves them out.
/// *usual*: sends a shadow ray for every point that faces the light.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "common/job.h"
#include "rt/render/plan.h"
#include "rt/render/render.h"
#include "rt/render/threads.h"

namespace rt::bench {
namespace {

/// Whether a ray from `o`, unit direction `d`, meets the ball, and where first.
bool meets(const Vec3& from_centre, double radius, const Vec3& d, double& t) {
  const double b = glm::dot(from_centre, d);
  const Vec3 nearest = from_centre - b * d;
  const double rest = radius * radius - glm::dot(nearest, nearest);
  if (!(rest >= 0.0)) {
    return false;
  }
  t = -b - std::sqrt(rest);
  return t > 0.0;
}

struct Scene {
  Vec3 centre;  ///< from the eye
  double radius;
  Vec3 light;  ///< from the eye
  Rgb colour, ambient, background;
  Material material;
  double least_r_dot_v;
};

Scene scene_of(const RenderJob& job) {
  const Instance& ball = job.instances.at(0);
  const auto& sphere = std::get<Sphere>(*ball.shape);
  const Light& light = job.lights.at(0);
  const Material& m = *ball.material;
  // The renderer leaves out what is below max_error / 256 in all.
  const double faint = job.options.max_error / 256.0 / std::max({m.ks.r, m.ks.g, m.ks.b});
  return {ball.world_from_model.point(sphere.centre) - job.camera.eye,
          sphere.radius * ball.world_from_model.linear[0][0],
          light.position - job.camera.eye,
          light.colour,
          m.kd * job.ambient + m.emission,
          job.options.background.top,
          m,
          std::pow(faint, 1.0 / m.shininess)};
}

template <bool shadow_rays>
Rgb colour(const Scene& s, const Vec3& d) {
  double t = 0.0;
  if (!meets(-s.centre, s.radius, d, t)) {
    return s.background;
  }
  const Vec3 p = t * d;
  const Vec3 n = (p - s.centre) / s.radius;
  const Vec3 to_light = s.light - p;
  const Vec3 l = to_light / glm::length(to_light);
  const double n_dot_l = glm::dot(n, l);
  Rgb sum = s.ambient;
  if (n_dot_l <= 0.0) {
    return sum;
  }
  double shaded = 0.0;
  // Off the surface by a little that suits this scene: a loop for one scene may do so.
  if (shadow_rays && meets(p + 1e-9 * n - s.centre, s.radius, l, shaded)) {
    return sum;
  }
  Rgb reflected = s.material.kd * n_dot_l;
  const double r_dot_v = glm::dot(l, d) - 2.0 * n_dot_l * glm::dot(n, d);
  if (r_dot_v > s.least_r_dot_v) {
    reflected += s.material.ks * std::pow(r_dot_v, s.material.shininess);
  }
  return sum + s.colour * reflected;
}

template <bool shadow_rays>
[[gnu::noinline]] Film by_hand(const RenderJob& job) {
  const int width = job.options.width;
  const int height = job.options.height;
  const Scene s = scene_of(job);
  const Vec3 forward = glm::normalize(job.camera.view);
  const double half = std::tan(0.5 * job.camera.fov * 3.14159265358979323846 / 180.0);
  const Vec3 right = half * width / height * glm::normalize(glm::cross(forward, job.camera.up));
  const Vec3 down = -half * glm::normalize(glm::cross(right, forward));
  Film film(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3 d = forward + (2.0 * (x + 0.5) / width - 1.0) * right +
                     (2.0 * (y + 0.5) / height - 1.0) * down;
      film.set(x, y, colour<shadow_rays>(s, d * (1.0 / glm::length(d))));
    }
  }
  return film;
}

/// Largest difference of any value, what cannot be displayed clamped.
double largest_difference(const Film& a, const Film& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const auto shown = [](float v) { return double{std::clamp(v, 0.0F, 1.0F)}; };
    worst = std::max(worst, std::abs(shown(a.pixels[i]) - shown(b.pixels[i])));
  }
  return worst;
}

template <class Work>
double seconds(const Work& work) {
  const double begin = thread_seconds();
  work();
  return thread_seconds() - begin;
}

void run(RenderJob job, int rounds) {
  const RenderPlan plan = make_plan(job);
  const Crop all{0, 0, job.options.width, job.options.height};
  const Film ours = render(plan, all, {}).film;
  const double apart = largest_difference(ours, by_hand<false>(job));
  if (!(std::max(apart, largest_difference(ours, by_hand<true>(job))) <= 1.0 / 255.0)) {
    fmt::print(stderr, "bench_yardstick: the pictures differ by {:g}\n", apart);
    std::exit(1);
  }
  fmt::print("round,renderer,least,usual,largest_difference\n");
  for (int i = 0; i < rounds; ++i) {
    const double renderer = seconds([&] { render(plan, all, {}); });
    const double least = seconds([&] { by_hand<false>(job); });
    const double usual = seconds([&] { by_hand<true>(job); });
    fmt::print("{},{:.6f},{:.6f},{:.6f},{:.3g}\n", i, renderer, least, usual, apart);
  }
}

}  // namespace
}  // namespace rt::bench

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: bench_yardstick SCENE.lua WIDTHxHEIGHT ROUNDS\n");
    return 2;
  }
  rt::RenderJob job = rt::bench::first_job(argv[1]);
  rt::parse_size(argv[2], job.options.width, job.options.height);
  rt::with_threads(1, [&] { rt::bench::run(std::move(job), std::stoi(argv[3])); });
}
