#pragma once
/// Single rays through the renderer, in double precision: no film rounds their radiance.
#include <cmath>

#include "rt/render/tracer.h"
#include "scenes.h"

namespace rt::test {

/// The mean of a number of samples, and how far chance may have moved it.
struct Estimate {
  Rgb mean{0.0};
  Rgb standard_error{0.0};
};

/// Follows rays through a scene. The eye of `job`'s camera should be the origin: rays are given in
/// render space.
class Probe {
 public:
  explicit Probe(const RenderJob& job) : plan_(make_plan(job)), tracer_(plan_) {}

  const RenderPlan& plan() const { return plan_; }
  const RayCounts& counts() const { return counts_; }

  Rgb operator()(const Vec3& origin, const Vec3& direction,
                 const Sampler& sampler = Sampler(0, 0, 0, 0)) {
    return tracer_.radiance({origin, direction}, 0.5, sampler, counts_);
  }

  /// `pixels` independent means of `samples` each. Their spread tells the error of the whole mean.
  Estimate estimate(const Vec3& origin, const Vec3& direction, int pixels, std::uint32_t samples) {
    Rgb sum(0.0);
    Rgb squares(0.0);
    for (int x = 0; x < pixels; ++x) {
      const Sampler first(1, x, 0, 0);
      Rgb mean(0.0);
      for (std::uint32_t i = 0; i < samples; ++i) {
        mean += (*this)(origin, direction, first.at(i)) / static_cast<double>(samples);
      }
      sum += mean;
      squares += mean * mean;
    }
    const double n = pixels;
    const Rgb mean = sum / n;
    // The difference of two rounded sums may come out a little below zero.
    const Rgb variance = glm::max(Rgb(0.0), squares / n - mean * mean) / (n - 1);
    return {mean, glm::sqrt(variance)};
  }

 private:
  RenderPlan plan_;
  Tracer tracer_;
  RayCounts counts_;
};

/// A job whose render space is the world, in which no branch is too faint to follow.
inline RenderJob bare_job() {
  RenderJob job = job_looking({0, 0, 0}, {0, 0, -1}, 1, 1);
  job.options.max_depth = 40;
  job.options.max_error = 1e-12;
  return job;
}

inline Material glass(double ior) {
  Material m = matt(Rgb(0.0));
  m.ior = ior;
  m.opacity = 0.0;
  return m;
}

inline Material glowing(const Rgb& radiance) {
  Material m = matt(Rgb(0.0));
  m.emission = radiance;
  return m;
}

/// A mark so small that a ray meets it only when it passes where it was computed to: what it shines
/// arrives multiplied by the weight of the path that leads there, else 0.
inline RenderJob with_mark(RenderJob job, const Vec3& at, double radius = 1e-9) {
  add(job, Sphere{at, radius}, {}, glowing(Rgb(1.0)));
  return job;
}

/// The unpolarised reflectance straight from its definition, in the angles.
inline double fresnel_by_angles(double cos_i, double n1, double n2) {
  const double sin_t = n1 / n2 * std::sqrt(1.0 - cos_i * cos_i);
  if (sin_t >= 1.0) {
    return 1.0;
  }
  const double cos_t = std::sqrt(1.0 - sin_t * sin_t);
  const double s = (n1 * cos_i - n2 * cos_t) / (n1 * cos_i + n2 * cos_t);
  const double p = (n2 * cos_i - n1 * cos_t) / (n2 * cos_i + n1 * cos_t);
  return 0.5 * (s * s + p * p);
}

/// Snell's law in the plane of d and n, unit vectors, d.n < 0. Must not be totally reflected.
inline Vec3 refracted_by_angles(const Vec3& d, const Vec3& n, double n1, double n2) {
  const Vec3 along = d - glm::dot(d, n) * n;  // of length sin_i
  const Vec3 t = n1 / n2 * along;
  return t - std::sqrt(1.0 - glm::dot(t, t)) * n;
}

}  // namespace rt::test
