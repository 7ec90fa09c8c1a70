#include "rt/render/scene_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "rt/render/query.h"
#include "rt/render/shading.h"

namespace rt {
namespace {

std::string text(const Vec3& v) { return fmt::format("({:g}, {:g}, {:g})", v.x, v.y, v.z); }

bool is_black(const Film& film) {
  return std::ranges::all_of(film.pixels, [](float value) { return value == 0.0f; });
}

/// Whether every row is of one colour, as a background is.
bool has_even_rows(const Film& film) {
  const std::size_t row = 3 * static_cast<std::size_t>(film.width);
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    if (i % row >= 3 && film.pixels[i] != film.pixels[i - 3]) {
      return false;
    }
  }
  return true;
}

/// The solid that a point lies in, as its first crossing in some direction tells. Squares, planes
/// and meshes are not taken for solids: they may be open.
std::optional<std::uint32_t> solid_around(const RenderPlan& plan, const Vec3& point,
                                          const Vec3& direction) {
  const TraceRay ray{point, direction};
  const auto hit = closest_hit(plan, ray);
  if (!hit || shading_point(plan, ray, *hit).side != Leaving::inward) {
    return std::nullopt;
  }
  const PlannedInstance& solid = plan.instances[hit->instance];
  const bool may_be_open = solid.is<Plane>() || solid.is<Square>() || solid.is<Mesh>();
  return may_be_open ? std::nullopt : std::optional(hit->instance);
}

/// Of a planned instance. The shapes of visible lights, which follow those of the job, are no
/// walls.
bool is_opaque(const RenderJob& job, const RenderPlan& plan, std::uint32_t instance) {
  const PlannedInstance& planned = plan.instances[instance];
  return planned.order < job.instances.size() && !planned.clear;
}

/// What camera rays on a coarse grid meet.
struct View {
  bool anything = false;
  /// The opaque solid that the eye is in, when no ray meets anything else.
  std::optional<std::uint32_t> shut_in;
};

View look(const RenderJob& job, const RenderPlan& plan) {
  constexpr int across = 24;
  View view;
  std::set<std::optional<std::uint32_t>> met;
  for (int i = 0; i < across * across; ++i) {
    const Vec3 direction =
        plan.camera.direction((i % across + 0.5) / across, (i / across + 0.5) / across);
    view.anything = view.anything || closest_hit(plan, {Vec3(0.0), direction});
    met.insert(solid_around(plan, Vec3(0.0), direction));
  }
  if (met.size() == 1 && *met.begin() && is_opaque(job, plan, **met.begin())) {
    view.shut_in = *met.begin();
  }
  return view;
}

void warn_of_lights(const RenderJob& job, const RenderPlan& plan,
                    std::vector<std::string>& warnings) {
  const Vec3 any_direction(0.36, 0.48, 0.8);
  const auto around_eye = solid_around(plan, Vec3(0.0), any_direction);
  for (std::size_t i = 0; i < job.lights.size(); ++i) {
    if (plan.lights[i].extended()) {
      continue;  // it may reach out
    }
    const Light& light = job.lights[i];
    const auto around = solid_around(plan, plan.lights[i].position, any_direction);
    if (around && around != around_eye && is_opaque(job, plan, *around)) {
      warnings.push_back(fmt::format(
          "{}{}the light at {} is inside '{}', whose surface lets no light out; move it, or make "
          "that material transparent",
          light.where, light.where.empty() ? "" : ": ", text(light.position),
          job.instances[*around].name));
    }
  }
}

}  // namespace

std::vector<std::string> scene_warnings(const RenderJob& job, const RenderPlan& plan,
                                        const Film& film) {
  std::vector<std::string> warnings;
  const std::string where = job.where.empty() ? "" : job.where + ": ";
  warn_of_lights(job, plan, warnings);
  const RenderOptions& options = plan.options;
  if (options.time_limit > 0.0 &&
      (fixed_samples(options) > 0 || options.aa == AntiAliasing::corners)) {
    warnings.push_back(where +
                       "time_limit does nothing where the number of samples is given: leave out "
                       "'samples' and 'aa', and the picture takes what the time allows");
  }
  const bool black = is_black(film);
  if (!black && !has_even_rows(film)) {
    return warnings;
  }
  const View view = look(job, plan);
  if (job.instances.empty()) {
    warnings.push_back(where + "there is no shape in the scene; add some below the node rendered");
  } else if (!view.anything) {
    warnings.push_back(
        fmt::format("{}nothing is in view: from {} in the direction {} the camera sees no shape",
                    where, text(job.camera.eye), text(job.camera.view)));
  } else if (view.shut_in) {
    warnings.push_back(fmt::format(
        "{}the camera at {} is inside '{}' and sees nothing else; move it out, or put things in",
        where, text(job.camera.eye), job.instances[*view.shut_in].name));
  } else if (black && job.lights.empty() && job.ambient == Rgb(0.0)) {
    warnings.push_back(where +
                       "the picture is all black: there are neither lights nor ambient light");
  } else if (black) {
    warnings.push_back(
        where + "the picture is all black: no light reaches what is in view, or it is all black");
  }
  return warnings;
}

}  // namespace rt
