#pragma once
/// Worlds that can be scaled and moved off as a whole, and pictures of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rt/render/render.h"
#include "rt/render/threads.h"
#include "rt/scene/render_job.h"

namespace rt::test {

/// p -> scale p + offset, applied to everything.
struct Placement {
  double scale = 1.0;
  Vec3 offset{0.0};
};

class World {
 public:
  World(const Placement& placement, int width = 160, int height = 120) : at_(placement) {
    job_.options.width = width;
    job_.options.height = height;
    job_.options.samples = 1;
    job_.ambient = Rgb(0.25);
    job_.options.background = {{0.2, 0.3, 0.6}, {0.8, 0.8, 0.9}};
  }

  void look(const Vec3& eye, const Vec3& target, double fov, const Vec3& up = {0, 1, 0}) {
    job_.camera = {placed(eye), target - eye, up, fov};
  }
  void light(const Vec3& position, double brightness = 0.75) {
    Light light;
    light.position = placed(position);
    light.colour = Rgb(brightness);
    job_.lights.push_back(light);
  }
  void add(const Shape& shape, const Affine& world_from_model, const Material& material) {
    const Affine whole =
        Affine::translation(at_.offset) * Affine::scaling(Vec3(at_.scale)) * world_from_model;
    job_.instances.push_back({whole, std::make_shared<const Shape>(shape),
                              std::make_shared<const Material>(material), nullptr, "test"});
  }
  RenderJob& job() { return job_; }

  Film picture() const {
    std::optional<RenderResult> result;
    with_threads(1, [&] {
      result = render(make_plan(job_), {0, 0, job_.options.width, job_.options.height}, {});
    });
    EXPECT_EQ(result->statistics.bad_samples, 0u);
    return std::move(result->film);
  }

 private:
  Vec3 placed(const Vec3& p) const { return at_.scale * p + at_.offset; }

  Placement at_;
  RenderJob job_;
};

inline Material matt(const Rgb& kd) {
  Material m;
  m.kd = kd;
  return m;
}
inline Material mirror() {
  Material m = matt(Rgb(0.05));
  m.reflectivity = Rgb(0.8);
  return m;
}
inline Material glass() {
  Material m = matt(Rgb(0.0));
  m.opacity = 0.0;
  m.ior = 1.5;
  return m;
}

inline double displayed(float linear) {
  const double v = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
}

/// How many pixels differ by more than 1/255 as displayed.
inline int differing_pixels(const Film& a, const Film& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
    for (std::size_t k = i; k < i + 3; ++k) {
      if (!(std::abs(displayed(a.pixels[k]) - displayed(b.pixels[k])) <= 1.0 / 255.0)) {
        ++count;
        break;
      }
    }
  }
  return count;
}

inline bool has_contrast(const Film& film) {
  const auto [lo, hi] = std::minmax_element(film.pixels.begin(), film.pixels.end());
  return *hi - *lo > 0.1F;
}

}  // namespace rt::test
