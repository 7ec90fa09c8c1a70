#include "light_lines.h"

#include <algorithm>

#include "rt/math/rounding.h"

namespace rt {
namespace {

/// Whether all of an instance stands before the light, rounding considered: what touches the
/// light's plane does not.
template <class Map>
bool before(const Bounds& box, const Map& map, const ShadingPoint& point, const SeenLight& seen) {
  const Vec3 half = 0.5 * box.extent();
  const Vec3 centre = map.render_point(box.centre());
  double depth = glm::dot(centre - point.position, seen.depth_axis());
  for (int k = 0; k < 3; ++k) {
    Vec3 edge(0.0);
    edge[k] = half[k];
    depth += std::abs(glm::dot(map.render_vector(edge), seen.depth_axis()));
  }
  // Of a position and its map, of the light's, and of some twenty sums and products here.
  const double error =
      point.position_error + gamma(32) * (max_abs(centre) + max_abs(point.position) +
                                          map.render_per_model() * max_abs(half) + seen.depth());
  return depth + error < seen.depth();
}

}  // namespace

Blockers::Blockers(const RenderPlan& plan, const Candidates& candidates, const ShadingPoint& point,
                   const SeenLight& seen)
    : scene(plan), dims(plan.dims && (plan.absorbs || candidates.dims)) {
  for (const std::uint32_t id : candidates.instances) {
    const PlannedInstance& instance = plan.instances[id];
    if (instance.shadow != Shadow::blocks) {
      continue;
    }
    const bool own = id == point.instance;
    if (own && instance.convex && point.side == Leaving::outward) {
      continue;  // the light above the surface is not hidden by it
    }
    const Bounds box = model_box_of(plan, instance);
    const bool told = !own && !instance.moves() && instance.convex && box.finite();
    plan.map(instance, 0.0, [&](const auto& map) {
      if (!told || !before(box, map, point, seen)) {
        others.add(id);
        return;
      }
      const double reach = max_abs(point.position) + map.render_per_model() * map.model_offset();
      convex[convex_count++] = {
          id, map.model_point(point.position),
          point.position_error + gamma(4 + std::decay_t<decltype(map)>::roundings) * reach};
    });
  }
}

VisibleParts::VisibleParts(const LightLine& line, const Blockers& blockers, FewInstances& unknown)
    : line_(line) {
  std::array<Span, ShadowCache::most> hidden;
  std::size_t count = 0;
  for (std::size_t i = 0; i < blockers.convex_count; ++i) {
    const Blockers::Convex& b = blockers.convex[i];
    const RenderPlan& plan = blockers.scene;
    const PlannedInstance& instance = plan.instances[b.id];
    const Fan fan = plan.map(instance, 0.0, [&](const auto& map) {
      return Fan{b.origin, map.model_vector(line.start), map.model_vector(line.step), b.nearest};
    });
    const auto span = plan.visit(instance, [&](const auto& shape) { return stopped(shape, fan); });
    if (!span) {
      unknown.add(b.id);
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

double VisibleParts::cosine(const Vec3& n) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    sum += line_.cosine_to(parts_[i].hi, n) - line_.cosine_to(parts_[i].lo, n);
  }
  return sum;
}

Vec3 VisibleParts::direction(double u) const {
  double rest = u * angle_;
  std::size_t i = 0;
  for (; i + 1 < count_ && rest > angle_of(parts_[i]); ++i) {
    rest -= angle_of(parts_[i]);
  }
  const Span& part = parts_[i];
  const double s = line_.at_angle(line_.angle_to(part.lo) + rest);
  return line_.direction(std::clamp(s, part.lo, part.hi));
}

void VisibleParts::add(double lo, double hi) {
  if (lo < hi) {
    parts_[count_++] = {lo, hi};
    angle_ += angle_of(parts_[count_ - 1]);
  }
}

Lines::Lines(const ShadingPoint& point, const SeenLight& seen, const Blockers& blockers)
    : point_(point), seen_(seen), one_horizon_(point.normal == point.shading_normal) {
  if (one_horizon_) {  // with two the light's own mean is not known
    const LightLine middle = through(seen.middle());
    FewInstances unknown;
    const double here = VisibleParts(middle, blockers, unknown).angle();
    const double all = middle.angle_to(middle.last) - middle.angle_to(middle.first);
    beta_ = here > 0.0 ? here / all : 0.0;
  }
}

LightLine Lines::through(const Vec2& place) const {
  LightLine line = seen_.line(place);
  line.clip(point_.shading_normal);
  if (!one_horizon_) {
    line.clip(point_.normal);
  }
  return line;
}

double Lines::cosine(const LightLine& line, const VisibleParts& parts, double mean) const {
  const Vec3& n = point_.shading_normal;
  if (parts.all() && beta_ == 1.0) {
    return mean;
  }
  if (parts.angle() == 0.0 && beta_ == 0.0) {
    return 0.0;
  }
  const double lit =
      line.first < line.last ? line.cosine_to(line.last, n) - line.cosine_to(line.first, n) : 0.0;
  const double here = parts.all() ? lit : parts.cosine(n);
  return here / line.angle() + beta_ * (mean - lit / line.angle());
}

}  // namespace rt
