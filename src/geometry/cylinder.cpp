#include "rt/geometry/cylinder.h"

#include "chords.h"
#include "disc.h"
#include "longitude.h"

namespace rt {
namespace {

constexpr std::uint32_t side_feature = 0;
constexpr std::uint32_t bottom_feature = 1;
constexpr std::uint32_t top_feature = 2;

constexpr Round side{1, gamma(12)};

Chord chord_of(const Cylinder&, const Ray& ray, const Recentred& line, double) {
  const Vec3& d = ray.direction;
  Chord chord;
  clip_cylinder(chord, side, ray, line, d.x * d.x + d.z * d.z, side_feature);
  chord.clip_slab(line.origin.y, d.y, 0, bottom_feature, 1, top_feature);
  return chord;
}

/// Where a ray that starts on feature `left`, going inward, comes out.
OptionalHit leave(const Cylinder&, const Ray& ray, double t_max, std::uint32_t left) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double across = d.x * d.x + d.z * d.z;
  Chord chord;
  if (left == side_feature && across > 0) {
    // One root is 0 exactly, so the other is the negative linear term.
    chord.clip(-infinity, 0, -2 * (o.x * d.x + o.z * d.z) / across, side_feature);
  } else if (left != side_feature) {
    clip_cylinder(chord, side, ray, {o, 0, 0}, across, side_feature);
  }
  if (d.y != 0) {
    chord.clip(-infinity, 0, ((d.y > 0 ? 1 : 0) - o.y) / d.y,
               d.y > 0 ? top_feature : bottom_feature);
  }
  return exit_hit(chord.t_out, chord.out, t_max);
}

/// The distance from the axis takes two squares, a sum and a root: its error is below gamma(3)
/// times itself.
Coincidence coincidence(const Cylinder&, const Ray& ray, double error) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double radius = std::sqrt(o.x * o.x + o.z * o.z);
  const double radial_error = error + gamma(3) * radius;
  if (!(radius <= 1 + radial_error && o.y >= -error && o.y <= 1 + error)) {
    return {Leaving::nothing, 0};
  }
  const bool on_side = std::abs(radius - 1) <= radial_error;
  const bool on_bottom = std::abs(o.y) <= error;
  Touching touching;
  touching.face(on_side, o.x * d.x + o.z * d.z);
  touching.face(on_bottom, -d.y);
  touching.face(std::abs(o.y - 1) <= error, d.y);
  return {touching.side(), on_side ? side_feature : (on_bottom ? bottom_feature : top_feature)};
}

}  // namespace

OptionalHit intersect(const Cylinder& shape, const Ray& ray, double t_max, const RayStart& start) {
  return intersect_convex<chord_of, coincidence, leave>(shape, ray, t_max, start);
}

SurfacePoint surface_point(const Cylinder&, const Ray& ray, const ShapeHit& hit) {
  if (hit.feature != side_feature) {
    const bool top = hit.feature == top_feature;
    return level_point(ray, hit.t, top ? 1 : 0, top ? 1 : -1);
  }
  const Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  const Meridian m = meridian(p);
  const Vec3 normal(m.cosine, 0, m.sine);
  return {Vec3(m.cosine, glm::clamp(p.y, 0.0, 1.0), m.sine), normal, normal};
}

/// The side as in the specification.
SurfaceCoordinates surface_coordinates(const Cylinder&, const SurfacePoint& point,
                                       std::uint32_t feature) {
  const Vec3& p = point.position;
  if (feature == side_feature) {
    return {{turns(p.z, p.x), p.y}, two_pi * Vec3(-p.z, 0, p.x), Vec3(0, 1, 0)};
  }
  return disc_coordinates(p, feature == top_feature ? 1 : -1);
}

Vec3 normal_change(const Cylinder&, const SurfacePoint&, std::uint32_t feature, const Vec3& step) {
  return feature == side_feature ? Vec3(step.x, 0, step.z) : Vec3(0.0);
}

Bounds bounds(const Cylinder&) { return {Vec3(-1, 0, -1), Vec3(1, 1, 1)}; }

}  // namespace rt
