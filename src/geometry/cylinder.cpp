#include "rt/geometry/cylinder.h"

#include "convex.h"
#include "longitude.h"
#include "rt/math/rounding.h"
#include "wide.h"

namespace rt {
namespace {

constexpr std::uint32_t side_feature = 0;
constexpr std::uint32_t bottom_feature = 1;
constexpr std::uint32_t top_feature = 2;

/// Where a line is inside the infinite cylinder x^2 + z^2 <= 1. `across` = dx^2 + dz^2.
void clip_side(Chord& chord, const Ray& ray, const Recentred& line, double across) {
  const Vec3& o = line.origin;
  const Vec3& d = ray.direction;
  if (!(across > 0)) {
    // Parallel to the axis: inside or not, exactly.
    const DoubleDouble square =
        squared(DoubleDouble(ray.origin.x)) + squared(DoubleDouble(ray.origin.z));
    chord.t_out = square <= 1 ? chord.t_out : -infinity;
    return;
  }
  // From the line's point nearest to the axis, so that nothing cancels: see recentre.h.
  const double middle = -(o.x * d.x + o.z * d.z) / across;
  const double x = std::fma(middle, d.x, o.x);
  const double z = std::fma(middle, d.z, o.z);
  double square = 1 - (x * x + z * z);
  if (std::abs(square) <= gamma(12)) {  // two recentrings, squares and sums: rounding decides
    const WidePoint p = wide_point(ray, line, middle);
    square = static_cast<double>(1 - squared(p.x) - squared(p.z));
  }
  const double half = std::sqrt(square / across);
  if (half >= 0) {
    chord.clip(middle - half, side_feature, middle + half, side_feature);
  } else {
    chord.t_out = -infinity;  // NaN: the line passes by
  }
}

/// Where a ray that starts on feature `left`, going inward, comes out.
OptionalHit leave_cylinder(const Ray& ray, double t_max, std::uint32_t left) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double across = d.x * d.x + d.z * d.z;
  Chord chord;
  if (left == side_feature && across > 0) {
    // One root is 0 exactly, so the other is the negative linear term.
    chord.clip(-infinity, 0, -2 * (o.x * d.x + o.z * d.z) / across, side_feature);
  } else if (left != side_feature) {
    clip_side(chord, ray, {o, 0, 0}, across);
  }
  if (d.y != 0) {
    chord.clip(-infinity, 0, ((d.y > 0 ? 1 : 0) - o.y) / d.y,
               d.y > 0 ? top_feature : bottom_feature);
  }
  return exit_hit(chord.t_out, chord.out, t_max);
}

struct Coincidence {
  Leaving side;
  std::uint32_t feature;
};

/// The side to which the ray leaves, if its origin lies on the surface within `error`. The distance
/// from the axis takes two squares, a sum and a root: its error is below gamma(3) times itself.
Coincidence coincidence(const Ray& ray, double error) {
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
  const double direction_squared = glm::dot(ray.direction, ray.direction);
  if (start.leaving == Leaving::outward || !usable(ray, direction_squared)) {
    return {};
  }
  if (start.leaving == Leaving::inward) {
    return leave_cylinder(ray, t_max, start.feature);
  }
  const Vec3& d = ray.direction;
  const Recentred line = recentred(ray.origin, d, direction_squared);
  Chord chord;
  clip_side(chord, ray, line, d.x * d.x + d.z * d.z);
  chord.clip_slab(line.origin.y, d.y, 0, bottom_feature, 1, top_feature);
  if (chord.empty()) {
    return {};
  }
  if (start.position_error > 0) {
    const auto [side, feature] = coincidence(ray, start.position_error);
    if (side != Leaving::nothing) {
      return intersect(shape, ray, t_max, {side, feature, 0});
    }
  }
  chord.t_in = line.ray_parameter(chord.t_in);
  chord.t_out = line.ray_parameter(chord.t_out);
  return first_hit(chord, t_max);
}

SurfacePoint surface_point(const Cylinder&, const Ray& ray, const ShapeHit& hit) {
  Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  if (hit.feature == side_feature) {
    const Meridian m = meridian(p);
    const Vec3 normal(m.cosine, 0, m.sine);
    return {Vec3(m.cosine, glm::clamp(p.y, 0.0, 1.0), m.sine), normal, normal};
  }
  p.y = hit.feature == top_feature ? 1 : 0;
  const Vec3 normal(0, hit.feature == top_feature ? 1 : -1, 0);
  return {p, normal, normal};
}

/// The side as in the specification; the discs are seen from outside, unmirrored, u along +x.
SurfaceCoordinates surface_coordinates(const Cylinder&, const SurfacePoint& point,
                                       std::uint32_t feature) {
  const Vec3& p = point.position;
  if (feature == side_feature) {
    return {{turns(p.z, p.x), p.y}, two_pi * Vec3(-p.z, 0, p.x), Vec3(0, 1, 0)};
  }
  const double v_sign = feature == top_feature ? -1 : 1;
  return {{(1 + p.x) / 2, (1 + v_sign * p.z) / 2}, Vec3(2, 0, 0), Vec3(0, 0, 2 * v_sign)};
}

Vec3 normal_change(const Cylinder&, const SurfacePoint&, std::uint32_t feature, const Vec3& step) {
  return feature == side_feature ? Vec3(step.x, 0, step.z) : Vec3(0.0);
}

Bounds bounds(const Cylinder&) { return {Vec3(-1, 0, -1), Vec3(1, 1, 1)}; }

}  // namespace rt
