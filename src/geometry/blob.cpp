#include "rt/geometry/blob.h"

#include "chords.h"
#include "disc.h"
#include "longitude.h"

namespace rt {
namespace {

constexpr std::uint32_t head_feature = 0;
constexpr std::uint32_t body_feature = 1;
constexpr std::uint32_t base_feature = 2;

constexpr double apex = Blob::apex;
constexpr double join = Blob::join;
constexpr double slant = 5 / apex;  ///< cosine of the angle of the body's normal to the horizon
constexpr double base = -1;
constexpr Round head_ball{1, gamma(12)};
constexpr Nappe body_nappe{apex, 26, 5};
constexpr double base_radius = body_nappe.width_at(base);

/// The chord of the whole: `head` and `body` are those of the ball and of the unbounded cone.
Chord cut_to_size(Chord head, Chord body, const Vec3& o, const Vec3& d) {
  body.clip_slab(o.y, d.y, base, base_feature, join, body_feature);
  head.clip_slab(o.y, d.y, join, head_feature, 2, head_feature);
  return d.y > 0 ? joined(body, head) : joined(head, body);
}

Chord chord_of(const Blob&, const Ray& ray, const Recentred& line, double direction_squared) {
  // The whole blob lies within 1 + base_radius of the origin.
  const double reach = 1 + base_radius;
  if (!(glm::dot(line.origin, line.origin) <= reach * reach)) {
    return {infinity, -infinity};
  }
  Chord head;
  Chord body;
  clip_ball(head, head_ball, 0, ray, line, direction_squared, head_feature);
  clip_nappe(body, body_nappe, ray, line, body_feature);
  return cut_to_size(head, body, line.origin, ray.direction);
}

/// Where a ray that starts on feature `left`, going inward, comes out.
OptionalHit leave(const Blob&, const Ray& ray, double t_max, std::uint32_t left) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double direction_squared = glm::dot(d, d);
  Chord head;
  Chord body;
  if (left == head_feature) {
    // One root is 0 exactly, so the other is the negative linear term.
    head.clip(0, head_feature, -2 * glm::dot(o, d) / direction_squared, head_feature);
  } else {
    const Recentred line = recentred(o, d, direction_squared);
    clip_ball(head, head_ball, 0, ray, line, direction_squared, head_feature);
    head.t_in = line.ray_parameter(head.t_in);
    head.t_out = line.ray_parameter(head.t_out);
  }
  if (left == body_feature) {
    body.clip(0, body_feature, NappeQuadratic(body_nappe, o, d).exit_from_surface(), body_feature);
  } else {
    clip_nappe(body, body_nappe, ray, {o, 0, 0}, body_feature);
  }
  const Chord chord = cut_to_size(head, body, o, d);
  return exit_hit(chord.empty() ? 0 : chord.t_out, chord.empty() ? left : chord.out, t_max);
}

/// Distances to sphere and cone take at most five roundings of quantities no larger than
/// |origin| + apex.
Coincidence coincidence(const Blob&, const Ray& ray, double error) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const Meridian m = meridian(o);
  const double length = std::sqrt(glm::dot(o, o));
  const double slack = error + gamma(5) * (length + apex);
  const double off_body = slant * (m.radius - body_nappe.width_at(o.y));
  const double off_head = length - 1;
  const bool in_head = o.y >= join - error && off_head <= slack;
  const bool in_body = o.y <= join + error && o.y >= base - error && off_body <= slack;
  const bool on_head = in_head && off_head >= -slack;
  const bool on_body = in_body && off_body >= -slack;
  Touching touching;
  touching.face(on_head, glm::dot(o, d));
  touching.face(on_body, 5 * (m.cosine * d.x + m.sine * d.z) + d.y);
  touching.face(in_body && std::abs(o.y - base) <= error, -d.y);
  return {touching.side(), on_head ? head_feature : (on_body ? body_feature : base_feature)};
}

}  // namespace

OptionalHit intersect(const Blob& shape, const Ray& ray, double t_max, const RayStart& start) {
  return intersect_convex<chord_of, coincidence, leave>(shape, ray, t_max, start);
}

SurfacePoint surface_point(const Blob&, const Ray& ray, const ShapeHit& hit) {
  if (hit.feature == base_feature) {
    return level_point(ray, hit.t, base, -1);
  }
  Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  if (hit.feature == head_feature) {
    const Vec3 normal = glm::normalize(p);
    return {normal, normal, normal};
  }
  const Meridian m = meridian(p);
  const Vec3 normal(slant * m.cosine, join, slant * m.sine);
  const double off = slant * (m.radius - body_nappe.width_at(p.y));
  p -= off * normal;
  // From afar the last place of t may carry a hit of the rim over it.
  const double y = glm::clamp(p.y, base, join);
  if (y != p.y) {
    p = Vec3(body_nappe.width_at(y) * m.cosine, y, body_nappe.width_at(y) * m.sine);
  }
  return {p, normal, normal};
}

/// Longitude and latitude of the direction from the origin, which sees every point of the surface
/// once. With rho = cot(latitude) * y: on the cone |p|^2 / apex is the speed of rho by latitude, on
/// the base |p|^2.
SurfaceCoordinates surface_coordinates(const Blob&, const SurfacePoint& point,
                                       std::uint32_t feature) {
  const Vec3& p = point.position;
  const Meridian m = meridian(p);
  const double square = glm::dot(p, p);
  Vec3 along;  // dp / dlatitude
  if (feature == head_feature) {
    along = Vec3(-p.y * m.cosine, m.radius, -p.y * m.sine);
  } else if (feature == body_feature) {
    along = square / apex * Vec3(-m.cosine, 5, -m.sine);
  } else {
    along = square * Vec3(m.cosine, 0, m.sine);
  }
  return {{turns(p.z, p.x), 0.5 + std::atan2(p.y, m.radius) / std::numbers::pi},
          two_pi * Vec3(-p.z, 0, p.x),
          std::numbers::pi * along};
}

Vec3 normal_change(const Blob&, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step) {
  if (feature == head_feature) {
    return step;
  }
  return feature == base_feature ? Vec3(0.0) : turned_about_axis(point, step);
}

Bounds bounds(const Blob&) {
  // base_radius is rounded: outward by its two roundings.
  const double reach = base_radius * (1 + gamma(3));
  return {Vec3(-reach, base, -reach), Vec3(reach, 1, reach)};
}

}  // namespace rt
