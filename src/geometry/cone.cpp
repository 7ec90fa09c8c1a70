#include "rt/geometry/cone.h"

#include <algorithm>

#include "convex.h"
#include "longitude.h"
#include "rt/math/rounding.h"
#include "wide.h"

namespace rt {
namespace {

constexpr std::uint32_t side_feature = 0;
constexpr std::uint32_t disc_feature = 1;
constexpr double slant = std::numbers::sqrt2 / 2;  ///< components of the side's normal: 45 degrees

/// Everything about the side is computed as seen from the apex: what is rounded there is of the
/// size of the distance from it, as the side's radius is.
const Vec3 apex(0, 1, 0);

/// x^2 + z^2 - y^2 along a line, from the apex: a t^2 + 2 b t + c, at most 0 inside either nappe.
struct ConeQuadratic {
  double a, b, c;
  double noise;  ///< bounds the rounding error of b^2 - a c, of whose terms some cancel

  ConeQuadratic(const Vec3& o, const Vec3& d) {
    const double across = d.x * d.x + d.z * d.z;
    const double radius = o.x * o.x + o.z * o.z;
    a = across - d.y * d.y;
    b = o.x * d.x + o.z * d.z - o.y * d.y;
    c = radius - o.y * o.y;
    // Each of the three: two products, two factors rounded before, two sums. Twice, for the
    // recentring before.
    const double b_terms = std::abs(o.x * d.x) + std::abs(o.z * d.z) + std::abs(o.y * d.y);
    noise = 2 * gamma(6) *
            (2 * std::abs(b) * b_terms + std::abs(a) * (radius + o.y * o.y) +
             std::abs(c) * (across + d.y * d.y));
  }
};

/// The quadratic's discriminant. For a line flatter than the slope it is -a times the value at the
/// vertex -b / a, which decides tangency; where rounding would, that value is computed in twice the
/// digits. A steeper line always crosses twice: at the apex' height it is not inside.
double discriminant(const ConeQuadratic& q, const Ray& ray, const Recentred& line) {
  const double value = difference_of_products(q.b, q.b, q.a, q.c);
  if (!(q.a > 0 && std::abs(value) <= q.noise)) {
    return q.a < 0 ? std::max(value, 0.0) : value;
  }
  const WidePoint p = wide_point(ray, line, -q.b / q.a);
  return -q.a * static_cast<double>(squared(p.x) + squared(p.z) - squared(1 - p.y));
}

/// Where a line, seen from the apex, is inside the nappe below.
void clip_side(Chord& chord, const Ray& ray, const Recentred& line) {
  const Vec3& o = line.origin;
  const Vec3& d = ray.direction;
  const ConeQuadratic q(o, d);
  const double root = std::sqrt(discriminant(q, ray, line));
  if (!(root >= 0)) {
    chord.t_out = -infinity;
    return;
  }
  const double sum = -(q.b + std::copysign(root, q.b));
  if (sum == 0) {  // through the apex, and along the slope or crossing nothing but the apex
    if (q.a >= 0 || d.y == 0) {
      chord.t_out = -infinity;
      return;
    }
    const double at_apex = -o.y / d.y;
    d.y < 0 ? chord.clip(at_apex, side_feature, infinity, side_feature)
            : chord.clip(-infinity, side_feature, at_apex, side_feature);
    return;
  }
  // The root without cancellation, and the other from the product of the two. As a goes through
  // zero (the line turns parallel to the cone's slope) first goes to infinity, as it should.
  const double first = sum / q.a;
  const double second = q.c / sum;
  const double lo = std::min(first, second);
  const double hi = std::max(first, second);
  if (q.a >= 0) {  // flatter than the slope: both crossings are of one nappe
    if (o.y + second * d.y <= 0) {
      chord.clip(lo, side_feature, hi, side_feature);
    } else {
      chord.t_out = -infinity;
    }
  } else if (d.y < 0) {  // steeper: downward the line stays inside for ever
    chord.clip(hi, side_feature, infinity, side_feature);
  } else {
    chord.clip(-infinity, side_feature, lo, side_feature);
  }
}

/// Where a ray that starts on feature `left`, going inward, comes out.
OptionalHit leave_cone(const Ray& ray, double t_max, std::uint32_t left) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  Chord chord;
  if (left == side_feature) {
    // One root is 0 exactly, so the other is the negative linear term.
    const ConeQuadratic q(o - apex, d);
    chord.clip(0, side_feature, q.a > 0 ? -2 * q.b / q.a : infinity, side_feature);
  } else {
    clip_side(chord, ray, {o - apex, 0, 0});
  }
  if (d.y < 0) {
    chord.clip(-infinity, side_feature, -o.y / d.y, disc_feature);
  }
  return exit_hit(chord.empty() ? 0 : chord.t_out, chord.empty() ? left : chord.out, t_max);
}

struct Coincidence {
  Leaving side;
  std::uint32_t feature;
};

/// The side to which the ray leaves, if its origin lies on the surface within `error`. The distance
/// from the side takes at most five roundings of quantities no larger than |origin| + 1.
Coincidence coincidence(const Ray& ray, double error) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const Meridian m = meridian(o);
  const double slack = error + gamma(5) * (m.radius + std::abs(o.y) + 1);
  const double off_side = slant * (m.radius - (1 - o.y));
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
  const double direction_squared = glm::dot(ray.direction, ray.direction);
  if (start.leaving == Leaving::outward || !usable(ray, direction_squared)) {
    return {};
  }
  if (start.leaving == Leaving::inward) {
    return leave_cone(ray, t_max, start.feature);
  }
  // From the apex; what the height's difference loses of a distant origin is given back after.
  const DoublePair height = exact_difference(ray.origin.y, apex.y);
  Recentred line =
      recentred({ray.origin.x, height.high, ray.origin.z}, ray.direction, direction_squared);
  line.origin.y += height.low;
  // The whole cone lies within sqrt(2) of its apex.
  if (!(glm::dot(line.origin, line.origin) <= 2 + gamma(16))) {
    return {};
  }
  Chord chord;
  clip_side(chord, ray, line);
  // Heights are the model's own, lest a line just below the disc be rounded onto it.
  const double dy = ray.direction.y;
  const double y = std::fma(line.residual, dy, std::fma(line.shift, dy, ray.origin.y));
  chord.clip_slab(y, dy, 0, disc_feature, 1, side_feature);
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

SurfacePoint surface_point(const PointedCone&, const Ray& ray, const ShapeHit& hit) {
  Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  if (hit.feature == disc_feature) {
    p.y = 0;
    return {p, Vec3(0, -1, 0), Vec3(0, -1, 0)};
  }
  const Meridian m = meridian(p);
  const Vec3 normal = slant * Vec3(m.cosine, 1, m.sine);
  const double off = slant * (m.radius - (1 - p.y));
  return {p - off * normal, normal, normal};
}

/// The side by longitude and height; the disc as a cylinder's lower one.
SurfaceCoordinates surface_coordinates(const PointedCone&, const SurfacePoint& point,
                                       std::uint32_t feature) {
  const Vec3& p = point.position;
  if (feature == disc_feature) {
    return {{(1 + p.x) / 2, (1 + p.z) / 2}, Vec3(2, 0, 0), Vec3(0, 0, 2)};
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
