#include "rt/geometry/torus.h"

#include <algorithm>
#include <array>

#include "convex.h"
#include "first_crossing.h"
#include "longitude.h"
#include "rt/math/rounding.h"
#include "torus_dips.h"
#include "torus_form.h"

namespace rt {
namespace {

/// The quartic along a line through its point nearest to the centre, direction of unit length: the
/// cubic term vanishes. s^4 + c2 s^2 + c1 s + c0.
struct Quartic {
  double c2, c1, c0;

  double operator()(double s) const { return ((s * s + c2) * s + c1) * s + c0; }
  double slope(double s) const { return (4 * s * s + 2 * c2) * s + c1; }
  double curvature(double s) const { return 12 * s * s + 2 * c2; }
};

Quartic quartic_of(const Torus& torus, const Vec3& o, const Vec3& d) {
  const double R = torus.major_radius;
  const double r = torus.minor_radius;
  const double h = glm::dot(o, o);
  const double R4 = 4 * R * R;
  // The constant term, h - R^2 - r^2 squared less 4 R^2 (r^2 - y^2), in factored form.
  return {2 * (h - R * R - r * r) + R4 * d.y * d.y, 2 * R4 * o.y * d.y,
          (h - (R + r) * (R + r)) * (h - (R - r) * (R - r)) + R4 * o.y * o.y};
}

/// The quartic from a point of the torus, divided by its root 0 there: s^3 + c2 s^2 + c1 s + c0.
struct Cubic {
  double c2, c1, c0;

  double operator()(double s) const { return ((s + c2) * s + c1) * s + c0; }
  double slope(double s) const { return (3 * s + 2 * c2) * s + c1; }
  double curvature(double s) const { return 6 * s + 2 * c2; }
};

Cubic cubic_of(const Torus& torus, const Vec3& o, const Vec3& d) {
  const double R = torus.major_radius;
  const double r = torus.minor_radius;
  const double od = glm::dot(o, d);
  const double rho = std::sqrt(o.x * o.x + o.z * o.z);
  const double sheet = sheet_at(torus, rho, o.y);
  // The gradient of the product of both factors where one of them is zero: well-conditioned however
  // thin the ring.
  const double gradient =
      8 * R * ((sheet * rho - R) * (o.x * d.x + o.z * d.z) + sheet * rho * o.y * d.y);
  return {4 * od, 2 * (glm::dot(o, o) - R * R - r * r) + 4 * od * od + 4 * R * R * d.y * d.y,
          gradient};
}

/// 64 u, times the size to the power of the polynomial's degree: bounds the rounding error of both
/// polynomials. With lengths in units of R + r their terms are at most 1, 8, 8 and 5 in size,
/// through at most eight roundings each on the way: less than 22 * 3 u on average, and the sum of
/// all terms never comes near all its bounds at once.
constexpr double polynomial_noise = 64 * 2 * unit_roundoff;

/// The polynomial's iteration stops at steps below this. What it leaves is of the order of the
/// step's square, and the finish on the geometric form, of third order over distances below the
/// tube's radius, takes that to rounding in one step. Where the hole is narrow or closed the torus
/// has features much smaller than that radius (a spindle's tips, where two sheets meet): there the
/// polynomial is followed down to rounding, so that the finish cannot stray to another root.
double coarse_step(const Torus& torus) {
  return (has_wide_hole(torus) ? 0x1p-8 : 0x1p-26) * torus.minor_radius;
}

double size_of(const Torus& torus) { return torus.major_radius + torus.minor_radius; }

/// The next crossing of a ray that starts on the torus, at u > 0 with the direction's length one.
/// The crossing at 0 is divided out, and the side to which the ray leaves decides the sign.
std::optional<double> next_crossing(const TorusLine& line, Leaving side) {
  const Torus& torus = line.torus;
  const double size = line.size();
  const double sign = side == Leaving::outward ? 1 : -1;
  Cubic cubic = cubic_of(torus, line.ray.origin, line.direction);
  cubic.c0 = sign * std::max(sign * cubic.c0, 0.0);
  const double end = 2.5 * size;  // a chord is no longer than 2 (R + r)
  // Up to a tube's radius away from the start the cubic is as good as the geometric form, and
  // unlike that has no root at 0; further on it is worse but no longer needed. It turns from
  // concave to convex at its inflection.
  const double near = torus.minor_radius;
  const double turn = std::clamp(-cubic.c2 / 3, 0.0, end);
  const std::array<Piece, 3> pieces{Piece{0, std::min(near, turn), false},
                                    Piece{std::min(near, turn), std::max(near, turn), near >= turn},
                                    Piece{std::max(near, turn), end, true}};
  for (const Piece& piece : pieces) {
    if (!(piece.begin < piece.end)) {
      continue;
    }
    const bool close = piece.end <= near;
    const Accuracy accuracy =
        close ? Accuracy{0, 0}
              : Accuracy{polynomial_noise * size * size * size, coarse_step(torus)};
    std::optional<double> s = first_crossing(cubic, piece, sign, accuracy);
    if (s && !close) {
      s = finish_root(line, *s, sign, piece.begin);
    }
    if (s) {
      return s;
    }
  }
  return {};
}

OptionalHit leave_torus(const Torus& torus, const Ray& ray, double t_max, Leaving side) {
  const double length = glm::length(ray.direction);
  const std::optional<double> u =
      next_crossing({torus, ray, {ray.origin, 0, 0}, ray.direction / length, length}, side);
  if (side == Leaving::inward) {
    return exit_hit(u ? *u / length : 0, 0, t_max);
  }
  return u ? hit_in_range(*u / length, 0, t_max) : OptionalHit{};
}

/// Inside the solid exactly one of the two factors is negative: in the lemon of a spindle torus
/// both are.
bool inside(const Torus& torus, const Vec3& p) {
  const double rho = std::sqrt(p.x * p.x + p.z * p.z);
  return (factor(torus, rho, p.y, 1) < 0) != (factor(torus, rho, p.y, -1) < 0);
}

/// How far p is from the tube's surface.
double distance(const Torus& torus, const Vec3& p) {
  const double rho = std::sqrt(p.x * p.x + p.z * p.z);
  const double w = rho - sheet_at(torus, rho, p.y) * torus.major_radius;
  return std::abs(std::sqrt(w * w + p.y * p.y) - torus.minor_radius);
}

/// The side to which a ray leaves whose origin lies on the torus within `error`. Three operations
/// give rho, one w, three the distance: each rounds something of at most |o| + R.
Leaving coincidence(const Torus& torus, const Vec3& o, const Vec3& d, double error) {
  const double reach = glm::length(o) + torus.major_radius;
  if (!(distance(torus, o) <= error + gamma(7) * reach)) {
    return Leaving::nothing;
  }
  return cubic_of(torus, o, d).c0 < 0 ? Leaving::inward : Leaving::outward;
}

/// The stretch of the line inside the torus' bounding sphere and slab, inflated by more than their
/// rounding: 16 u of the sphere's square and of the slab's half-width plus the size.
Chord clip_to_bounds(const Torus& torus, const Vec3& o, const Vec3& d) {
  const double size = size_of(torus);
  Chord chord;
  const double square = size * size * (1 + 16 * unit_roundoff) - glm::dot(o, o);
  if (!(square >= 0)) {
    chord.t_out = -infinity;
    return chord;
  }
  const double half = std::sqrt(square);
  const double thickness = torus.minor_radius + 16 * unit_roundoff * size;
  // No branch on the direction's sign, which is anyone's guess. For d.y = 0 both quotients are
  // infinite, or one is NaN (on the slab's face) and loses every comparison.
  const double per_y = 1 / d.y;
  const double lower = (-thickness - o.y) * per_y;
  const double upper = (thickness - o.y) * per_y;
  chord.t_in = std::max(-half, std::min(lower, upper));
  chord.t_out = std::min(half, std::max(lower, upper));
  return chord;
}

/// The first crossing within the chord; `sign` is the quartic's sign at its beginning.
std::optional<double> first_quartic_root(const TorusLine& line, const Chord& chord, double sign) {
  const double size = line.size();
  const Quartic quartic = quartic_of(line.torus, line.line.origin, line.direction);
  // Convex but for the stretch between the inflections, if there are any.
  const double turn = quartic.c2 < 0 ? std::sqrt(-quartic.c2 / 6) : 0;
  const double left = std::clamp(-turn, chord.t_in, chord.t_out);
  const double right = std::clamp(turn, chord.t_in, chord.t_out);
  const std::array<Piece, 3> pieces{Piece{chord.t_in, left, true}, Piece{left, right, false},
                                    Piece{right, chord.t_out, true}};
  const Accuracy accuracy{polynomial_noise * size * size * size * size, coarse_step(line.torus)};
  for (const Piece& piece : pieces) {
    if (!(piece.begin < piece.end)) {
      continue;
    }
    std::optional<double> s = first_crossing(quartic, piece, sign, accuracy);
    if (s) {
      s = finish_root(line, *s, sign, chord.t_in);
    }
    if (s) {
      return s;
    }
  }
  return {};
}

std::optional<double> first_root(const TorusLine& line, const Chord& chord, double sign) {
  if (sign > 0 && chord.t_in < chord.t_out && has_wide_hole(line.torus)) {
    const Verdict verdict = crossing_from_outside(line, chord);
    if (verdict.certain) {
      return verdict.s < infinity ? std::optional(verdict.s) : std::nullopt;
    }
  }
  return first_quartic_root(line, chord, sign);
}

}  // namespace

OptionalHit intersect(const Torus& shape, const Ray& ray, double t_max, const RayStart& start) {
  const double direction_squared = glm::dot(ray.direction, ray.direction);
  if (!usable(ray, direction_squared)) {
    return {};
  }
  if (start.leaving != Leaving::nothing) {
    return leave_torus(shape, ray, t_max, start.leaving);
  }
  const Recentred line = recentred(ray.origin, ray.direction, direction_squared);
  const double length = std::sqrt(direction_squared);
  const Vec3 d = ray.direction * (1 / length);
  Chord chord = clip_to_bounds(shape, line.origin, d);
  const double begin = line.local_parameter(0) * length;
  if (!(begin <= chord.t_out && chord.t_in <= chord.t_out)) {
    return {};
  }
  if (start.position_error > 0) {
    const Leaving side = coincidence(shape, ray.origin, d, start.position_error);
    if (side != Leaving::nothing) {
      return leave_torus(shape, ray, t_max, side);
    }
  }
  double sign = 1;
  if (begin > chord.t_in) {
    chord.t_in = begin;
    sign = inside(shape, ray.origin) ? -1 : 1;
  }
  chord.t_out = std::min(chord.t_out, line.local_parameter(t_max) * length);
  const std::optional<double> s = first_root({shape, ray, line, d, length}, chord, sign);
  if (!s) {
    return {};
  }
  const double t = line.ray_parameter(*s / length);
  if (t <= 0) {  // a start on the surface, to within rounding: this crossing lies behind
    return leave_torus(shape, ray, t_max, sign > 0 ? Leaving::inward : Leaving::outward);
  }
  return hit_in_range(t, 0, t_max);
}

SurfacePoint surface_point(const Torus& shape, const Ray& ray, const ShapeHit& hit) {
  const Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  const Meridian m = meridian(p);
  const double sheet = sheet_at(shape, m.radius, p.y);
  const double w = m.radius - sheet * shape.major_radius;
  const double length = std::sqrt(w * w + p.y * p.y);
  // Cosine and sine of the angle around the tube; its circle's centre is sheet * R along the
  // meridian.
  const double cosine = length > 0 ? w / length : 1;
  const double sine = length > 0 ? p.y / length : 0;
  const double radius = sheet * shape.major_radius + shape.minor_radius * cosine;
  const Vec3 normal = sheet * Vec3(cosine * m.cosine, sine, cosine * m.sine);
  return {Vec3(radius * m.cosine, shape.minor_radius * sine, radius * m.sine), normal, normal};
}

/// On the lemon of a spindle torus the tube's circle has its centre across the axis.
SurfaceCoordinates surface_coordinates(const Torus& shape, const SurfacePoint& point,
                                       std::uint32_t) {
  const Vec3& p = point.position;
  const Meridian m = meridian(p);
  const double sheet = sheet_at(shape, m.radius, p.y);
  const double cosine = sheet * m.cosine;
  const double sine = sheet * m.sine;
  const double w = sheet * m.radius - shape.major_radius;
  return {{turns(sheet * p.z, sheet * p.x), turns(p.y, w)},
          two_pi * Vec3(-p.z, 0, p.x),
          two_pi * Vec3(-p.y * cosine, w, -p.y * sine)};
}

/// The tube is a sphere of radius r that rides on the ring: normal = (p - centre) / r.
Vec3 normal_change(const Torus& shape, const SurfacePoint& point, std::uint32_t, const Vec3& step) {
  const Vec3& p = point.position;
  const Meridian m = meridian(p);
  const double R = sheet_at(shape, m.radius, p.y) * shape.major_radius;
  const Vec3 along(-m.sine, 0, m.cosine);
  const double turn = m.radius > 0 ? glm::dot(step, along) / m.radius : 0.0;
  const Vec3 from_ring = p - R * Vec3(m.cosine, 0, m.sine);
  const Vec3 change = (step - R * turn * along) / shape.minor_radius;
  return glm::dot(from_ring, point.normal) < 0 ? -change : change;
}

Bounds bounds(const Torus& shape) {
  const double reach = size_of(shape) * (1 + gamma(1));
  return {Vec3(-reach, -shape.minor_radius, -reach), Vec3(reach, shape.minor_radius, reach)};
}

}  // namespace rt
