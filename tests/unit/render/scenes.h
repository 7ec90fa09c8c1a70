#pragma once
/// Small scenes for the renderer's tests, built without a script.
#include "rt/render/render.h"
#include "rt/render/threads.h"
#include "rt/scene/render_job.h"

namespace rt::test {

inline Material matt(const Rgb& kd) {
  Material m;
  m.kd = kd;
  return m;
}

inline void add(RenderJob& job, const Shape& shape, const Affine& world_from_model,
                const Material& material) {
  job.instances.push_back({world_from_model, std::make_shared<const Shape>(shape),
                           std::make_shared<const Material>(material), nullptr, "test"});
}

/// A job whose camera at `eye` looks at `target`, of one sample a pixel.
inline RenderJob job_looking(const Vec3& eye, const Vec3& target, int width, int height) {
  RenderJob job;
  job.camera = {eye, target - eye, {0, 1, 0}, 30.0};
  job.options.width = width;
  job.options.height = height;
  job.options.samples = 1;
  return job;
}

inline RenderResult rendered(const RenderJob& job, int threads = 1) {
  std::optional<RenderResult> result;
  with_threads(threads, [&] {
    result = render(make_plan(job), {0, 0, job.options.width, job.options.height}, {});
  });
  return std::move(*result);
}

inline Rgb pixel(const Film& film, int x, int y) {
  const float* p =
      &film.pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                        static_cast<std::size_t>(x))];
  return {p[0], p[1], p[2]};
}

/// A bit of everything: shapes of every kind, mirrors, two lights.
inline RenderJob mixed_scene(int width, int height) {
  RenderJob job = job_looking({0, 3, 9}, {0, 0.7, 0}, width, height);
  Material mirror = matt({0.1, 0.1, 0.1});
  mirror.reflectivity = Rgb(0.7);
  Material shiny = matt({0.7, 0.3, 0.2});
  shiny.ks = Rgb(0.5);
  shiny.shininess = 40;
  add(job, Plane{}, {}, matt({0.6, 0.6, 0.5}));
  add(job, Sphere{}, Affine::translation({-2, 1, -1}), mirror);
  add(job, Box{}, Affine::translation({1.5, 0, 0.5}) * Affine::rotation(1, 30), shiny);
  add(job, Cylinder{}, Affine::translation({0.3, 0, 1.4}) * Affine::scaling({0.4, 1, 0.4}), shiny);
  add(job, Torus{}, Affine::translation({0.2, 1.2, -1.5}) * Affine::rotation(0, 70), mirror);
  add(job, Blob{}, Affine::translation({-1, 0.6, 2}) * Affine::scaling(Vec3(0.6)), shiny);
  auto data = std::make_shared<MeshData>();
  data->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  data->triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  add(job, Mesh{data}, Affine::translation({2.6, 0, 1.2}), shiny);
  for (int i = 0; i < 12; ++i) {
    add(job, Sphere{{0, 0, 0}, 0.15}, Affine::translation({-3 + 0.5 * i, 0.15, 3}), shiny);
  }
  job.ambient = Rgb(0.2);
  job.lights.push_back({.position = {4, 7, 5}, .colour = Rgb(0.7)});
  job.lights.push_back({.position = {-6, 5, 3}, .colour = Rgb(0.3)});
  job.options.background = {{0.2, 0.3, 0.6}, {0.8, 0.8, 0.9}};
  return job;
}

/// From standing still to a pose.
inline std::shared_ptr<const Motion> moving(const Pose& to) {
  auto motion = std::make_shared<Motion>();
  motion->keys = {{0.0, Pose{}}, {1.0, to}};
  return motion;
}

/// Lets the instance added last move.
inline void give_path(RenderJob& job, std::shared_ptr<const MotionPath> path) {
  Instance last = job.instances.back();
  last.motion = std::move(path);
  job.instances.replace(job.instances.size() - 1, last);
}

inline void add_moving(RenderJob& job, const Shape& shape, const Affine& placed,
                       const Material& material, std::shared_ptr<const Motion> motion) {
  add(job, shape, placed, material);
  give_path(job, extended(nullptr, {placed, std::move(motion)}));
}

}  // namespace rt::test
