#include "rt/geometry/cone.h"

#include "chords.h"
#include "disc.h"
#include "longitude.h"

namespace rt {
namespace {

constexpr std::uint32_t side_feature = 0;
constexpr std::uint32_t disc_feature = 1;

constexpr Nappe side{1, 1, 1, gamma(6)};  ///< moved by three recentrings, within 1 of the origin
constexpr double slant = std::numbers::sqrt2 / 2;  ///< components of the side's normal: 45 degrees

/// Where a line is inside the nappe. It is seen from its point nearest to the apex, so that
/// rounding is relative to the distance from there, as the cone's width is.
void clip_side(Chord& chord, const Ray& ray, const Recentred& line, double direction_squared) {
  const Vec3& d = ray.direction;
  const double middle = glm::dot(Vec3(0, 1, 0) - line.origin, d) / direction_squared;
  const Vec3 nearest = fused_at(line.origin, d, middle);
  Chord nappe;
  clip_nappe(nappe, side, ray, {nearest, line.shift, line.residual + middle}, side_feature);
  chord.clip(nappe.t_in + middle, side_feature, nappe.t_out + middle, side_feature);
}

Chord chord_of(const PointedCone&, const Ray& ray, const Recentred& line,
               double direction_squared) {
  // The whole cone lies within 1 of the origin.
  if (!(glm::dot(line.origin, line.origin) <= 1 + gamma(8))) {
    return {infinity, -infinity};
  }
  Chord chord;
  clip_side(chord, ray, line, direction_squared);
  chord.clip_slab(line.origin.y, ray.direction.y, 0, disc_feature, 1, side_feature);
  return chord;
}

/// Where a ray that starts on the side comes out of it. One root of the quadratic is 0; the other
/// has lost its digits where it is so near to the apex that the way there is long beside the
/// cone's width: then it is that of the line as seen from there.
double exit_from_side(const Ray& ray) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double t = NappeQuadratic(side, o, d).exit_from_surface();
  const double squared = glm::dot(d, d);
  if (!(t < infinity && std::abs(side.width_at(o.y + t * d.y)) < t * t * squared)) {
    return t;
  }
  Chord seen_from_apex;
  clip_side(seen_from_apex, ray, {o, 0, 0}, squared);
  return seen_from_apex.empty() ? t : std::max(0.0, seen_from_apex.t_out);
}

/// Where a ray that starts on feature `left`, going inward, comes out.
OptionalHit leave(const PointedCone&, const Ray& ray, double t_max, std::uint32_t left) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  Chord chord;
  if (left == side_feature) {
    chord.clip(0, side_feature, exit_from_side(ray), side_feature);
  } else {
    clip_side(chord, ray, {o, 0, 0}, glm::dot(d, d));
  }
  if (d.y < 0) {
    chord.clip(-infinity, side_feature, -o.y / d.y, disc_feature);
  }
  return exit_hit(chord.empty() ? 0 : chord.t_out, chord.empty() ? left : chord.out, t_max);
}

/// The distance from the side takes at most five roundings of quantities no larger than
/// |origin| + 1.
Coincidence coincidence(const PointedCone&, const Ray& ray, double error) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const Meridian m = meridian(o);
  const double slack = error + gamma(5) * (m.radius + std::abs(o.y) + 1);
  const double off_side = slant * (m.radius - side.width_at(o.y));
  const bool inside = o.y >= -error && o.y <= 1 + slack && off_side <= slack;
  const bool on_side = inside && off_side >= -slack;
  Touching touching;
  touching.face(on_side, m.cosine * d.x + m.sine * d.z + d.y);
  touching.face(inside && std::abs(o.y) <= error, -d.y);
  return {touching.side(), on_side ? side_feature : disc_feature};
}

}  // namespace

OptionalHit intersect(const PointedCone& shape, const Ray& ray, double t_max,
                      const RayStart& start) {
  return intersect_convex<chord_of, coincidence, leave>(shape, ray, t_max, start);
}

SurfacePoint surface_point(const PointedCone&, const Ray& ray, const ShapeHit& hit) {
  if (hit.feature == disc_feature) {
    return level_point(ray, hit.t, 0, -1);
  }
  Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  const Meridian m = meridian(p);
  const Vec3 normal = slant * Vec3(m.cosine, 1, m.sine);
  const double off = slant * (m.radius - side.width_at(p.y));
  p -= off * normal;
  // From afar the last place of t may carry a hit of the rim over it.
  const double y = glm::clamp(p.y, 0.0, 1.0);
  if (y != p.y) {
    p = Vec3(side.width_at(y) * m.cosine, y, side.width_at(y) * m.sine);
  }
  return {p, normal, normal};
}

/// The side by longitude and height; the disc as a cylinder's lower one.
SurfaceCoordinates surface_coordinates(const PointedCone&, const SurfacePoint& point,
                                       std::uint32_t feature) {
  const Vec3& p = point.position;
  if (feature == disc_feature) {
    return disc_coordinates(p, -1);
  }
  const Meridian m = meridian(p);
  return {{turns(p.z, p.x), glm::clamp(p.y, 0.0, 1.0)},
          two_pi * Vec3(-p.z, 0, p.x),
          Vec3(-m.cosine, 1, -m.sine)};
}

Vec3 normal_change(const PointedCone&, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step) {
  return feature == disc_feature ? Vec3(0.0) : turned_about_axis(point, step);
}

Bounds bounds(const PointedCone&) { return {Vec3(-1, 0, -1), Vec3(1, 1, 1)}; }

}  // namespace rt
