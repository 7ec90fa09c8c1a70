#include "rt/geometry/capsule.h"

#include "chords.h"
#include "longitude.h"

namespace rt {
namespace {

constexpr std::uint32_t side_feature = 0;
constexpr std::uint32_t lower_feature = 1;
constexpr std::uint32_t upper_feature = 2;

/// Where a line is inside the two whole balls and the unbounded cylinder.
struct Parts {
  Chord lower, body, upper;
};

Parts parts_of(const Capsule& shape, const Ray& ray, const Recentred& line,
               double direction_squared) {
  const Vec3& d = ray.direction;
  const Round round{shape.radius, gamma(12) * shape.radius * (shape.length + shape.radius)};
  Parts parts;
  clip_ball(parts.lower, round, 0, ray, line, direction_squared, lower_feature);
  clip_cylinder(parts.body, round, ray, line, d.x * d.x + d.z * d.z, side_feature);
  clip_ball(parts.upper, round, shape.length, ray, line, direction_squared, upper_feature);
  return parts;
}

/// The chord of the whole: each part counts between the planes where it joins the next.
Chord cut_to_size(const Capsule& shape, Parts parts, const Vec3& o, const Vec3& d) {
  const double reach = 2 * shape.radius;  // beyond the poles
  parts.lower.clip_slab(o.y, d.y, -reach, lower_feature, 0, lower_feature);
  parts.body.clip_slab(o.y, d.y, 0, side_feature, shape.length, side_feature);
  parts.upper.clip_slab(o.y, d.y, shape.length, upper_feature, shape.length + reach, upper_feature);
  return d.y > 0 ? joined(joined(parts.lower, parts.body), parts.upper)
                 : joined(joined(parts.upper, parts.body), parts.lower);
}

Chord chord_of(const Capsule& shape, const Ray& ray, const Recentred& line,
               double direction_squared) {
  return cut_to_size(shape, parts_of(shape, ray, line, direction_squared), line.origin,
                     ray.direction);
}

/// The nearest point of the line between the balls' centres.
Vec3 centre_for(const Capsule& shape, const Vec3& p) {
  return {0, glm::clamp(p.y, 0.0, shape.length), 0};
}

OptionalHit leave(const Capsule& shape, const Ray& ray, double t_max, std::uint32_t left) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double direction_squared = glm::dot(d, d);
  const Recentred line = recentred(o, d, direction_squared);
  Parts parts = parts_of(shape, ray, line, direction_squared);
  for (Chord* part : {&parts.lower, &parts.body, &parts.upper}) {
    part->t_in = line.ray_parameter(part->t_in);
    part->t_out = line.ray_parameter(part->t_out);
  }
  // Of the part that is left one root is 0 exactly, so the other is the negative linear term.
  const double across = d.x * d.x + d.z * d.z;
  if (left == side_feature) {
    const double out = across > 0 ? -2 * (o.x * d.x + o.z * d.z) / across : infinity;
    parts.body = {0, out, side_feature, side_feature};
  } else if (left == lower_feature) {
    parts.lower = {0, -2 * glm::dot(o, d) / direction_squared, lower_feature, lower_feature};
  } else {
    const Vec3 from_centre = o - Vec3(0, shape.length, 0);
    parts.upper = {0, -2 * glm::dot(from_centre, d) / direction_squared, upper_feature,
                   upper_feature};
  }
  const Chord chord = cut_to_size(shape, parts, o, d);
  return exit_hit(chord.empty() ? 0 : chord.t_out, chord.empty() ? left : chord.out, t_max);
}

/// The distance from the centre line takes at most five roundings of quantities no larger than
/// |origin| + length.
Coincidence coincidence(const Capsule& shape, const Ray& ray, double error) {
  const Vec3& o = ray.origin;
  const Vec3 from_centre = o - centre_for(shape, o);
  const double slack = error + gamma(5) * (glm::length(o) + shape.length);
  Touching touching;
  touching.face(std::abs(glm::length(from_centre) - shape.radius) <= slack,
                glm::dot(from_centre, ray.direction));
  return {touching.side(),
          o.y < 0 ? lower_feature : (o.y > shape.length ? upper_feature : side_feature)};
}

}  // namespace

OptionalHit intersect(const Capsule& shape, const Ray& ray, double t_max, const RayStart& start) {
  return intersect_convex<chord_of, coincidence, leave>(shape, ray, t_max, start);
}

SurfacePoint surface_point(const Capsule& shape, const Ray& ray, const ShapeHit& hit) {
  const Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  Vec3 centre(0.0);
  Vec3 normal = p;
  if (hit.feature == side_feature) {
    centre = centre_for(shape, p);
    const Meridian m = meridian(p);
    normal = {m.cosine, 0, m.sine};
  } else {
    centre.y = hit.feature == upper_feature ? shape.length : 0;
    normal = glm::normalize(p - centre);
  }
  return {centre + shape.radius * normal, normal, normal};
}

/// u by longitude, v by the way along the meridian from pole to pole.
SurfaceCoordinates surface_coordinates(const Capsule& shape, const SurfacePoint& point,
                                       std::uint32_t) {
  const Vec3& p = point.position;
  const Vec3& n = point.normal;
  const Meridian m = meridian(n);
  const double latitude = std::atan2(n.y, m.radius);
  const double whole = std::numbers::pi * shape.radius + shape.length;
  const double way =
      shape.radius * (std::numbers::pi / 2 + latitude) + glm::clamp(p.y, 0.0, shape.length);
  return {{turns(p.z, p.x), way / whole},
          two_pi * Vec3(-p.z, 0, p.x),
          whole * Vec3(-n.y * m.cosine, m.radius, -n.y * m.sine)};
}

Vec3 normal_change(const Capsule& shape, const SurfacePoint&, std::uint32_t feature,
                   const Vec3& step) {
  return Vec3(step.x, feature == side_feature ? 0 : step.y, step.z) / shape.radius;
}

Bounds bounds(const Capsule& shape) {
  const double r = shape.radius;
  return {Vec3(-r, -r, -r), Vec3(r, (shape.length + r) * (1 + gamma(2)), r)};
}

}  // namespace rt
