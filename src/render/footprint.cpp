#include "rt/render/footprint.h"

#include <algorithm>
#include <cmath>

#include "rt/render/adaptive.h"

namespace rt {
namespace {

/// The unit vector along v's part across `axis`; any one across where there is none.
Vec3 across(const Vec3& v, const Vec3& axis) {
  const Vec3 part = v - glm::dot(v, axis) * axis;
  const double length = glm::length(part);
  if (length > 0.0 && std::isfinite(length)) {
    return part / length;
  }
  const Vec3 other = std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, other));
}

}  // namespace

double sample_spacing(const RenderOptions& options) {
  const int fixed = fixed_samples(options);
  if (fixed > 0) {
    return 1.0 / std::sqrt(fixed);
  }
  if (options.aa == AntiAliasing::corners) {
    return 1.0;
  }
  // All samples of an adaptive pixel share one width, that of four at most. What a filter blurs no
  // further sample sharpens and no estimate sees, so it must stay well below max_error. It grows
  // with the width's square: on a checker of full contrast, half a pixel puts a pixel in twenty off
  // by 0.045 (bench/NOTES.md). Narrowed until that is a third of max_error.
  constexpr double off_at_half = 0.045;
  const double narrow = 0.5 * std::sqrt(options.max_error / (3.0 * off_at_half));
  return std::min(1.0 / std::sqrt(std::min(4.0, 1.0 * options.max_samples)), narrow);
}

RayDifferential camera_differential(const RenderPlan& plan, double spacing, const TraceRay& ray) {
  const RenderOptions& options = plan.options;
  if (!plan.moving_camera) {
    return camera_differential(plan.camera, options, spacing, ray.direction);
  }
  const double time = std::lerp(options.shutter_open, options.shutter_close, ray.time);
  return camera_differential(frame_of(at_time(*plan.moving_camera, time), options), options,
                             spacing, ray.direction);
}

// A lobe of density ~ cos^e has E[sin^2] = 2 / (e + 3), half of it along each axis; the box of that
// variance is sqrt(12 / (e + 3)) wide.
RayDifferential widened(const RayDifferential& perfect, const Vec3& drawn,
                        const PowerCosineLobe& lobe, double spacing) {
  const double lobe_width = spacing * std::sqrt(12.0 / (lobe.exponent() + 3.0));
  const auto wide = [&](const Vec3& dp, const Vec3& dd) {
    // Away from the ray's own place, so that the beam opens.
    return std::hypot(glm::length(dd), lobe_width) *
           across(glm::dot(dp, dp) > 0.0 ? dp : dd, drawn);
  };
  return {perfect.dp_dx, perfect.dp_dy, wide(perfect.dp_dx, perfect.dd_dx),
          wide(perfect.dp_dy, perfect.dd_dy)};
}

NormalDifferential normal_differential(const RenderPlan& plan, const ShadingPoint& point,
                                       const RayDifferential& at) {
  const PlannedInstance& instance = plan.instances[point.instance];
  const double sign = point.side == Leaving::outward ? 1.0 : -1.0;
  return plan.map(instance, point.time, [&](const auto& map) -> NormalDifferential {
    const SurfacePoint p{map.model_point(point.position), map.model_normal(sign * point.normal),
                         map.model_normal(sign * point.shading_normal)};
    const auto change = [&](const Vec3& step) {
      const Vec3 in_model = plan.visit(instance, [&](const auto& shape) {
        return normal_change(shape, p, point.feature, map.model_vector(step));
      });
      return unit_change(map.render_covector(p.shading_normal),
                         sign * map.render_covector(in_model));
    };
    return {point.shading_normal, change(at.dp_dx), change(at.dp_dy)};
  });
}

FootprintTrail::FootprintTrail(const RenderPlan& plan)
    : plan_(plan), spacing_(sample_spacing(plan.options)) {}

void FootprintTrail::begin(const TraceRay& camera_ray) {
  open_.clear();
  open_.push_back(camera_differential(plan_, spacing_, camera_ray));
}

void FootprintTrail::arrive(std::size_t open, const TraceRay& ray, double t, ShadingPoint& point) {
  // What lies above is of paths that met nothing.
  here_ = arrived(open_[open], ray.direction, t, point.normal);
  open_.resize(open);
  normal_.reset();
  point.footprint = std::sqrt(glm::length(here_.dp_dx) * glm::length(here_.dp_dy));
}

void FootprintTrail::branch(const ShadingPoint& point, const Vec3& incoming, const Vec3& direction,
                            double eta, const PowerCosineLobe* lobe) {
  if (!normal_) {
    normal_ = normal_differential(plan_, point, here_);
  }
  const RayDifferential next = glm::dot(direction, point.normal) > 0.0
                                   ? reflected(here_, incoming, *normal_)
                                   : refracted(here_, incoming, *normal_, eta);
  open_.push_back(lobe == nullptr ? next : widened(next, direction, *lobe, spacing_));
}

}  // namespace rt
