#include "rt/geometry/blob.h"

#include <algorithm>

#include "convex.h"
#include "longitude.h"
#include "rt/math/rounding.h"
#include "wide.h"

namespace rt {
namespace {

constexpr std::uint32_t head_feature = 0;
constexpr std::uint32_t body_feature = 1;
constexpr std::uint32_t base_feature = 2;

constexpr double apex = 5.0990195135927848;  ///< sqrt(26): the cone's tip is at (0, apex, 0)
constexpr double join = 1 / apex;            ///< height at which head and body meet
constexpr double slant = 5 / apex;  ///< cosine of the angle of the body's normal to the horizon
constexpr double base = -1;
constexpr double base_radius = (apex - base) / 5;

/// Where a line is inside the unit ball.
void clip_ball(Chord& chord, const Ray& ray, const Recentred& line, double direction_squared) {
  double square = 1 - glm::dot(line.origin, line.origin);
  if (std::abs(square) <= gamma(12)) {  // recentring, squares and sums: rounding decides
    const WidePoint p = wide_point(ray, line, 0);
    square = static_cast<double>(1 - squared(p.x) - squared(p.y) - squared(p.z));
  }
  const double half = std::sqrt(square / direction_squared);
  if (half >= 0) {
    chord.clip(-half, head_feature, half, head_feature);
  } else {
    chord.t_out = -infinity;
  }
}

/// The cone as a quadratic along a line: a t^2 + 2 b t + c <= 0 inside,
/// x^2 + z^2 - ((apex - y) / 5)^2.
struct ConeQuadratic {
  double a, b, c;
  double noise;  ///< bounds the rounding error of b^2 - a c, of whose terms some cancel

  ConeQuadratic(const Vec3& o, const Vec3& d) {
    const double width = (apex - o.y) / 5;
    const double growth = -d.y / 5;
    const double across = d.x * d.x + d.z * d.z;
    const double radius = o.x * o.x + o.z * o.z;
    const double along = o.x * d.x + o.z * d.z;
    a = across - growth * growth;
    b = along - width * growth;
    c = radius - width * width;
    // Each of the three: two products, one or two factors rounded before, two sums. Twice, for the
    // recentring before.
    const double b_terms = std::abs(o.x * d.x) + std::abs(o.z * d.z) + std::abs(width * growth);
    noise = 2 * gamma(6) *
            (2 * std::abs(b) * b_terms + std::abs(a) * (radius + width * width) +
             std::abs(c) * (across + growth * growth));
  }
};

/// The quadratic's discriminant. For a line flatter than the slope it is -a times the value at the
/// vertex -b / a, which decides tangency; where rounding would, that value is computed in twice the
/// digits. A steeper line always crosses twice (at the apex' height it is not inside).
double discriminant(const ConeQuadratic& q, const Ray& ray, const Recentred& line) {
  const double value = difference_of_products(q.b, q.b, q.a, q.c);
  if (!(q.a > 0 && std::abs(value) <= q.noise)) {
    return q.a < 0 ? std::max(value, 0.0) : value;
  }
  const WidePoint p = wide_point(ray, line, -q.b / q.a);
  const DoubleDouble width = (sqrt(DoubleDouble(26)) - p.y) / 5;
  return -q.a * static_cast<double>(squared(p.x) + squared(p.z) - squared(width));
}

/// Where a line is inside the nappe below the apex.
void clip_cone(Chord& chord, const Ray& ray, const Recentred& line) {
  const Vec3& o = line.origin;
  const Vec3& d = ray.direction;
  const ConeQuadratic q(o, d);
  const double root = std::sqrt(discriminant(q, ray, line));
  if (!(root >= 0)) {
    chord.t_out = -infinity;
    return;
  }
  // The root without cancellation, and the other from the product of the two. As a goes through
  // zero (the line turns parallel to the cone's slope) first goes to infinity, as it should.
  const double sum = -(q.b + std::copysign(root, q.b));
  const double first = sum / q.a;
  const double second = q.c / sum;
  const double lo = std::min(first, second);
  const double hi = std::max(first, second);
  if (q.a >= 0) {  // flatter than the slope: both crossings are of one nappe
    if (o.y + second * d.y <= apex) {
      chord.clip(lo, body_feature, hi, body_feature);
    } else {
      chord.t_out = -infinity;
    }
  } else if (d.y < 0) {  // steeper: downward the line stays inside for ever
    chord.clip(hi, body_feature, infinity, body_feature);
  } else {
    chord.clip(-infinity, body_feature, lo, body_feature);
  }
}

/// The chord of the whole solid. Head and body are each convex, and so is their union: the line
/// runs through one part, crosses the plane of the join and runs through the other. The join itself
/// is never an end of the chord, so there is no seam to fall through or to hit twice.
Chord joined(const Chord& first, const Chord& second) {
  if (first.empty()) {
    return second;
  }
  if (second.empty()) {
    return first;
  }
  return {first.t_in, second.t_out, first.in, second.out};
}

/// `head` and `body`: the chords of the ball and of the infinite cone. Cuts both to size.
Chord chord_of(Chord head, Chord body, const Vec3& o, const Vec3& d) {
  body.clip_slab(o.y, d.y, base, base_feature, join, body_feature);
  head.clip_slab(o.y, d.y, join, head_feature, 2, head_feature);
  return d.y > 0 ? joined(body, head) : joined(head, body);
}

/// Where a ray that starts on feature `left`, going inward, comes out.
OptionalHit leave_blob(const Ray& ray, double t_max, std::uint32_t left) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const double direction_squared = glm::dot(d, d);
  Chord head;
  Chord body;
  const ConeQuadratic q(o, d);
  if (left == head_feature) {
    // One root is 0 exactly, so the other is the negative linear term.
    head.clip(0, head_feature, -2 * glm::dot(o, d) / direction_squared, head_feature);
  } else {
    const Recentred line = recentred(o, d, direction_squared);
    clip_ball(head, ray, line, direction_squared);
    head.t_in = line.ray_parameter(head.t_in);
    head.t_out = line.ray_parameter(head.t_out);
  }
  if (left == body_feature) {
    body.clip(0, body_feature, q.a > 0 ? -2 * q.b / q.a : infinity, body_feature);
  } else {
    clip_cone(body, ray, {o, 0, 0});
  }
  const Chord chord = chord_of(head, body, o, d);
  return exit_hit(chord.empty() ? 0 : chord.t_out, chord.empty() ? left : chord.out, t_max);
}

struct Coincidence {
  Leaving side;
  std::uint32_t feature;
};

/// The side to which the ray leaves, if its origin lies on the surface within `error`. Distances to
/// sphere and cone take at most five roundings of quantities no larger than |origin| + apex.
Coincidence coincidence(const Ray& ray, double error) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const Meridian m = meridian(o);
  const double length = std::sqrt(glm::dot(o, o));
  const double slack = error + gamma(5) * (length + apex);
  const double off_body = slant * (m.radius - (apex - o.y) / 5);
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
  const double direction_squared = glm::dot(ray.direction, ray.direction);
  if (start.leaving == Leaving::outward || !usable(ray, direction_squared)) {
    return {};
  }
  if (start.leaving == Leaving::inward) {
    return leave_blob(ray, t_max, start.feature);
  }
  const Recentred line = recentred(ray.origin, ray.direction, direction_squared);
  // The whole blob lies within 1 + base_radius of the origin.
  const double reach = 1 + base_radius;
  if (!(glm::dot(line.origin, line.origin) <= reach * reach)) {
    return {};
  }
  Chord head;
  Chord body;
  clip_ball(head, ray, line, direction_squared);
  clip_cone(body, ray, line);
  Chord chord = chord_of(head, body, line.origin, ray.direction);
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

SurfacePoint surface_point(const Blob&, const Ray& ray, const ShapeHit& hit) {
  Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  if (hit.feature == head_feature) {
    const Vec3 normal = glm::normalize(p);
    return {normal, normal, normal};
  }
  if (hit.feature == base_feature) {
    p.y = base;
    return {p, Vec3(0, -1, 0), Vec3(0, -1, 0)};
  }
  const Meridian m = meridian(p);
  const Vec3 normal(slant * m.cosine, join, slant * m.sine);
  const double off = slant * (m.radius - (apex - p.y) / 5);
  p -= off * normal;
  // From afar the last place of t may carry a hit of the rim over it.
  const double y = glm::clamp(p.y, base, join);
  if (y != p.y) {
    p = Vec3((apex - y) / 5 * m.cosine, y, (apex - y) / 5 * m.sine);
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
