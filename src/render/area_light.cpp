/// Extended lights where few things can stand between.
///
/// A sample is a line across the light, through a point drawn on it uniformly in solid angle, in
/// place of the point alone. What the line's directions give in the mean, given where it lies, has
/// the same expectation, and of convex blockers it is known in closed form (fan.h): whether a point
/// of the light is seen is a coin thrown, how much of a line is seen varies slowly from line to
/// line. Source: Billen and Dutre, "Line sampling for direct illumination", EGSR 2016.
///
/// The diffuse part is integrated along the line; over the whole light, were it not hidden, its
/// mean is known too. With V the visible part of a line's cosines, C all of them, C0 the light's
/// mean, the estimate is V + beta (C0 - C): beta, the visible share of the line through the light's
/// middle, is 1 where nothing hides it and 0 in the core of a shadow. There the estimate is exact.
///
/// What lines cannot tell (other shapes, glass, highlights, falloff) is asked at one point, drawn
/// uniformly from the visible part of the line.
#include <algorithm>
#include <array>
#include <cmath>

#include "local_light.h"
#include "rt/geometry/fan.h"
#include "rt/math/rounding.h"
#include "rt/render/seen_light.h"

namespace rt {
namespace {

constexpr std::size_t most = ShadowCache::most;

/// What may hide a light from a point.
struct Blockers {
  struct Convex {
    const PlannedInstance* instance;
    std::uint32_t id;
    Vec3 origin;     ///< the point in its model space
    double nearest;  ///< Fan::nearest
  };
  std::array<Convex, most> convex;
  std::array<std::uint32_t, most> others;  ///< those that rays must be asked about
  std::size_t convex_count = 0, other_count = 0;
  bool dims = false;

  void add_other(std::uint32_t id) { others[other_count++] = id; }
};

/// Whether all of an instance stands before the light.
bool before(const PlannedInstance& instance, const ShadingPoint& point, const SeenLight& seen) {
  const Bounds box = std::visit([](const auto& shape) { return bounds(shape); }, *instance.shape);
  const Affine& map = instance.render_from_model;
  const Vec3 half = 0.5 * box.extent();
  double depth = glm::dot(map.point(box.centre()) - point.position, seen.depth_axis());
  for (int k = 0; k < 3; ++k) {
    depth += half[k] * std::abs(glm::dot(map.linear[k], seen.depth_axis()));
  }
  return depth < seen.depth();
}

Blockers sorted(const RenderPlan& plan, const Candidates& candidates, const ShadingPoint& point,
                const SeenLight& seen) {
  Blockers blockers;
  blockers.dims = plan.dims && (plan.absorbs || candidates.dims);
  for (const std::uint32_t id : candidates.instances) {
    const PlannedInstance& instance = plan.instances[id];
    if (instance.shadow != Shadow::blocks) {
      continue;
    }
    const bool own = id == point.instance;
    if (own && instance.convex && point.side == Leaving::outward) {
      continue;  // the light above the surface is not hidden by it
    }
    if (own || instance.motion || !has_spans(*instance.shape) || !before(instance, point, seen)) {
      blockers.add_other(id);
      continue;
    }
    const double reach = max_abs(point.position) +
                         instance.render_per_model * max_abs(instance.model_from_render.offset);
    blockers.convex[blockers.convex_count++] = {&instance, id,
                                                instance.model_from_render.point(point.position),
                                                point.position_error + gamma(16) * reach};
  }
  return blockers;
}

/// The parts of a line that convex blockers leave to be seen.
class VisibleParts {
 public:
  /// Those of which the line cannot tell go to `unknown`.
  template <class Unknown>
  VisibleParts(const LightLine& line, const Blockers& blockers, Unknown&& unknown) : line_(line) {
    std::array<Span, most> hidden;
    std::size_t count = 0;
    for (std::size_t i = 0; i < blockers.convex_count; ++i) {
      const Blockers::Convex& b = blockers.convex[i];
      const Affine& map = b.instance->model_from_render;
      const auto span = stopped(
          *b.instance->shape, {b.origin, map.vector(line.start), map.vector(line.step), b.nearest});
      if (!span) {
        unknown(b.id);
      } else if (span->lo < span->hi && span->lo < line.last && span->hi > line.first) {
        hidden[count++] = *span;
      }
    }
    std::sort(hidden.begin(), hidden.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Span& a, const Span& b) { return a.lo < b.lo; });
    all_ = count == 0;
    double from = line.first;
    for (std::size_t i = 0; i < count; ++i) {
      add(from, std::min(hidden[i].lo, line.last));
      from = std::max(from, hidden[i].hi);
    }
    add(from, line.last);
  }

  double angle() const { return angle_; }
  /// Nothing is hidden.
  bool all() const { return all_; }

  /// The integral of n.l over their angle.
  double cosine(const Vec3& n) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      sum += line_.cosine_to(parts_[i].hi, n) - line_.cosine_to(parts_[i].lo, n);
    }
    return sum;
  }

  /// The direction at a share u in (0,1) of the visible angle.
  Vec3 direction(double u) const {
    double rest = u * angle_;
    std::size_t i = 0;
    for (; i + 1 < count_ && rest > angle_of(parts_[i]); ++i) {
      rest -= angle_of(parts_[i]);
    }
    const Span& part = parts_[i];
    const double s = line_.at_angle(line_.angle_to(part.lo) + rest);
    return line_.direction(std::clamp(s, part.lo, part.hi));
  }

 private:
  double angle_of(const Span& part) const {
    return line_.angle_to(part.hi) - line_.angle_to(part.lo);
  }
  void add(double lo, double hi) {
    if (lo < hi) {
      parts_[count_++] = {lo, hi};
      angle_ += angle_of(parts_[count_ - 1]);
    }
  }

  const LightLine& line_;
  std::array<Span, most + 1> parts_;
  std::size_t count_ = 0;
  double angle_ = 0.0;
  bool all_ = false;
};

/// The direction of lines: away from the middle of the blocker that hides most, so that they cross
/// the edge of its shadow. It depends on nothing random.
Vec2 across_edge(const Blockers& blockers, const ShadingPoint& point, const SeenLight& seen) {
  double nearest = std::numeric_limits<double>::infinity();
  Vec2 way{1.0, 0.0};
  for (std::size_t i = 0; i < blockers.convex_count; ++i) {
    const PlannedInstance& instance = *blockers.convex[i].instance;
    const Bounds box = std::visit([](const auto& shape) { return bounds(shape); }, *instance.shape);
    const auto place =
        seen.seen_at(instance.render_from_model.point(box.centre()) - point.position);
    if (!place) {
      continue;
    }
    const Vec2 d = seen.middle() - *place;
    const double length = glm::length(d);
    if (length > 0.0 && length < nearest) {
      nearest = length;
      way = d / length;
    }
  }
  return way;
}

}  // namespace

std::optional<Rgb> area_light(const RenderPlan& plan, std::size_t index, const Phong& phong,
                              const ShadingPoint& point, const Vec3& view, const Sampler& sampler,
                              const Vertex& vertex, ShadowCache& cache, RayCounts& counts) {
  const Light& light = plan.lights[index];
  // Relative to the light: one that moves is still for a point that moves against it.
  const auto seen = SeenLight::from(point.position - point.time * light.travel, light);
  if (!seen) {
    return std::nullopt;
  }
  const Candidates candidates = cache.towards(index, point.position, true);
  if (!candidates.known) {
    return std::nullopt;
  }
  const Vec3& n = point.shading_normal;
  if (seen->above(-point.normal) || seen->above(-n)) {
    return Rgb(0.0);
  }
  Blockers blockers = sorted(plan, candidates, point, *seen);
  const bool even = light.falloff.c1 == 0.0 && light.falloff.c2 == 0.0;
  const Vec3 mirrored_view = 2.0 * glm::dot(n, view) * n - view;
  const bool shiny =
      phong.ks != Rgb(0.0) && seen->largest_cosine(mirrored_view) > phong.least_r_dot_v;
  const bool smooth = even && !shiny;
  const bool one_horizon = n == point.normal;
  const double dimming = falloff(light, glm::length(light.position - point.position));

  ++counts.shadow;
  const double mean = seen->mean_cosine(n);
  if (smooth && one_horizon && blockers.convex_count + blockers.other_count == 0 &&
      !blockers.dims) {
    return phong.kd * light.colour * (dimming * mean);
  }
  const auto line_through = [&](const Vec2& place, const Vec2& along) {
    LightLine line = seen->line(place, along);
    line.clip(n);
    if (!one_horizon) {
      line.clip(point.normal);
    }
    return line;
  };
  // A control variate's factor: any number that depends on nothing random will do.
  const Vec2 along = across_edge(blockers, point, *seen);
  double beta = 0.0;
  if (one_horizon) {
    const LightLine middle = line_through(seen->middle(), along);
    const double all = middle.angle_to(middle.last) - middle.angle_to(middle.first);
    const double here = VisibleParts(middle, blockers, [](std::uint32_t) {}).angle();
    beta = here > 0.0 ? here / all : 0.0;
  }
  const Vec2 through = seen->point_of(seen->sample(sampler.light(vertex)));
  const LightLine line = line_through(through, along);
  const VisibleParts parts(line, blockers, [&](std::uint32_t id) { blockers.add_other(id); });
  const bool asked = !smooth || blockers.other_count > 0 || blockers.dims;
  if (!asked && parts.angle() == 0.0 && beta == 0.0) {
    return Rgb(0.0);
  }
  const double whole = line.angle_to(line.hi) - line.angle_to(line.lo);
  double cosine = mean;
  if (!(parts.all() && beta == 1.0)) {
    const double lit =
        line.first < line.last ? line.cosine_to(line.last, n) - line.cosine_to(line.first, n) : 0.0;
    const double here = parts.all() ? lit : parts.cosine(n);
    cosine = here / whole + beta * (mean - lit / whole);
  }
  Rgb sum = phong.kd * (dimming * cosine);
  if (asked && parts.angle() > 0.0) {
    const double u = (line.angle_to(glm::dot(through, along)) - line.angle_to(line.lo)) / whole;
    const Vec3 way = parts.direction(u);
    const double distance = seen->distance(way);
    const Candidates rest{true, blockers.dims, {blockers.others.data(), blockers.other_count}};
    const Rgb arrived =
        visibility(plan, rest, point, way, free_distance(point, light, distance), counts);
    const Rgb there = reflected(phong, point, view, way) * arrived * falloff(light, distance);
    sum += (there - phong.kd * (dimming * glm::dot(n, way))) * (parts.angle() / whole);
  }
  return sum * light.colour;
}

}  // namespace rt
