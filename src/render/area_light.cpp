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
#include "light_lines.h"
#include "local_light.h"

namespace rt {
namespace {

/// Whether the highlight of the light can be seen.
bool shines(const Phong& phong, const ShadingPoint& point, const Vec3& view,
            const SeenLight& seen) {
  const Vec3& n = point.shading_normal;
  const Vec3 mirrored = 2.0 * glm::dot(n, view) * n - view;
  return phong.ks != Rgb(0.0) && seen.largest_cosine(mirrored) > phong.least_r_dot_v;
}

}  // namespace

std::optional<Rgb> area_light(const RenderPlan& plan, std::size_t index, const SeenLight& seen,
                              const Phong& phong, const ShadingPoint& point, const Vec3& view,
                              const Sampler& sampler, const Vertex& vertex, double negligible,
                              ShadowCache& cache, RayCounts& counts) {
  const PlannedLight& light = plan.lights[index];
  const Candidates candidates = cache.towards(index, cache.cell_of(point.position), true);
  if (!candidates.known) {
    return std::nullopt;
  }
  const Vec3& n = point.shading_normal;
  if (seen.above(-point.normal) || seen.above(-n)) {
    return Rgb(0.0);
  }
  ++counts.shadow;
  Blockers blockers(plan, candidates, point, seen);
  const bool even = light.falloff.c1 == 0.0 && light.falloff.c2 == 0.0;
  const bool smooth = even && !shines(phong, point, view, seen);
  const double away = even ? 0.0 : glm::length(light.position - relative_to(light, point));
  const Rgb diffuse = phong.kd * falloff(light, away);
  const double mean = seen.mean_cosine(n);
  if (smooth && !(max_abs(diffuse * light.colour) * mean > negligible)) {
    return Rgb(0.0);
  }
  if (blockers.none() && smooth && n == point.normal) {
    return diffuse * light.colour * mean;
  }
  const Lines lines(point, seen, blockers);
  const Vec2 place = seen.point_of(seen.sample(sampler.light(vertex)));
  const LightLine line = lines.through(place);
  const VisibleParts parts(line, blockers, blockers.others);
  Rgb sum = diffuse * lines.cosine(line, parts, mean);
  const bool told = smooth && blockers.others.count == 0 && !blockers.dims;
  if (!told && parts.angle() > 0.0) {
    const double from_end = line.angle_to(place.x) - line.angle_to(line.lo);
    const Vec3 way = parts.direction(from_end / line.angle());
    const double distance = seen.distance(way);
    const Candidates rest{true, blockers.dims, blockers.others.span()};
    const auto arrives =
        visibility(plan, rest, point, way, free_distance(point, light, distance), counts);
    const Rgb there = arrives
                          ? reflected(phong, point, view, way) * *arrives * falloff(light, distance)
                          : Rgb(0.0);
    sum += (there - diffuse * glm::dot(n, way)) * (parts.angle() / line.angle());
  }
  return sum * light.colour;
}

}  // namespace rt
