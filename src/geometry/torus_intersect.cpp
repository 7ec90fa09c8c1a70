#include <algorithm>

#include "convex.h"
#include "torus_dips.h"
#include "torus_leaving.h"
#include "torus_quartic.h"

/// Most of a torus' cost is waiting: for square roots and divisions in a row, and for branches that
/// were guessed wrong. Hence what the way of most rays needs is inlined here, depends on as little
/// as it can, and rejects early; what few rays need is called, and gets its arguments in memory
/// only then.
namespace rt {
namespace {

/// Whether the line passes the bounding sphere by, from |o|^2 |d|^2 - (o . d)^2, which is |d|^2
/// times its squared distance from the centre: before anything is divided. The two terms are
/// rounded nine and seven times, which moves their difference by less than 24 u |o|^2 |d|^2.
inline bool passes_by(const Torus& torus, const Vec3& o, double o_dot_d, double direction_squared) {
  const double size = size_of(torus);
  const double outside =
      glm::dot(o, o) * (1 - 24 * unit_roundoff) - size * size * (1 + 16 * unit_roundoff);
  return outside * direction_squared > o_dot_d * o_dot_d;
}

/// The ray's line from its point nearest to the centre, by arc length s: as Recentred, with what it
/// computes on the way put to more use.
struct Approach {
  Recentred line;
  Vec3 direction;
  double length, per_length;  ///< of the ray's direction
  double square;              ///< the line's squared distance from the centre
  double slack;               ///< and more than its rounding error

  double local(double t) const { return line.local_parameter(t) * length; }
};

inline Approach approach(const Ray& ray, double o_dot_d, double direction_squared) {
  const double length = std::sqrt(direction_squared);
  const double scale = -1 / direction_squared;
  const double shift = o_dot_d * scale;
  const Vec3 near = fused_at(ray.origin, ray.direction, shift);
  const double along = glm::dot(near, ray.direction);
  const double residual = along * scale;
  const double per_length = -scale * length;
  // The second step's part is taken off the square that is there already.
  const double square = glm::dot(near, near);
  return {{fused_at(near, ray.direction, residual), shift, residual},
          ray.direction * per_length,
          length,
          per_length,
          square + along * residual,
          16 * unit_roundoff * square};
}

struct Stretch {
  double begin, end;
};

/// The stretch of the line inside the torus' bounding sphere and slab, inflated by more than their
/// rounding: 16 u of the sphere's square and of the slab's half-width plus the size. NaNs, of a
/// line outside the sphere or a ray without a direction, lose every comparison.
inline Stretch within_bounds(const Torus& torus, const Approach& a) {
  const double size = size_of(torus);
  const double half = std::sqrt(size * size * (1 + 16 * unit_roundoff) + a.slack - a.square);
  const double thickness = torus.minor_radius + 16 * unit_roundoff * size;
  // No branch on the direction's sign, which is anyone's guess. For d.y = 0 both quotients are
  // infinite, or one is NaN (on the slab's face) and loses every comparison.
  const double per_y = 1 / a.direction.y;
  const double lower = (-thickness - a.line.origin.y) * per_y;
  const double upper = (thickness - a.line.origin.y) * per_y;
  return {std::max(-half, std::min(lower, upper)), std::min(half, std::max(lower, upper))};
}

/// Inside the solid exactly one of the two factors is negative: in the lemon of a spindle torus
/// both are.
bool inside(const Torus& torus, const Vec3& p) {
  const double rho = std::sqrt(p.x * p.x + p.z * p.z);
  return (factor(torus, rho, p.y, 1) < 0) != (factor(torus, rho, p.y, -1) < 0);
}

/// The hit of a crossing at s; `sign` is that of the quartic at the line's beginning.
OptionalHit hit_at(const TorusLine& line, std::optional<double> s, double sign, double t_max) {
  if (!s) {
    return {};
  }
  const double t = line.line.ray_parameter(*s / line.length);
  if (t <= 0) {  // a start on the surface, to within rounding: this crossing lies behind
    return leave_torus(line.torus, line.ray, t_max, sign > 0 ? Leaving::inward : Leaving::outward);
  }
  return hit_in_range(t, 0, t_max);
}

/// Rays that begin inside, and tori whose hole is narrow or closed.
[[gnu::noinline]] OptionalHit hit_by_quartic(const TorusLine& line, const Stretch& stretch,
                                             double sign, double t_max) {
  return hit_at(line, first_quartic_root(line, stretch.begin, stretch.end, sign), sign, t_max);
}

[[gnu::noinline]] OptionalHit hit_by_second_look(const TorusLine& line, const Sighting& first,
                                                 double t_max) {
  return hit_at(line, look_again(line, first), 1, t_max);
}

/// The line's passage through the cylinder that fits the torus' hole: from axis - half to axis +
/// half, NaN if there is none.
struct Hole {
  double axis, half;

  double exit() const { return axis + half; }
  bool holds(double s) const { return std::abs(s - axis) < half; }
};

/// Made smaller by more than the rounding of the discriminant, 4 u k (R + r)^2: R - r is a third of
/// R + r or more.
inline Hole hole_of(const Ring& ring) {
  const double inner = ring.R - ring.r;
  const double c = ring.o.x * ring.o.x + ring.o.z * ring.o.z;
  const double per_k = 1 / ring.k;
  const double discriminant =
      ring.b * ring.b - ring.k * (c - inner * inner * (1 - 64 * unit_roundoff));
  return {-ring.b * per_k, std::sqrt(discriminant) * per_k};
}

/// Looks for the first crossing of a line that begins outside a torus with a wide hole: two steps
/// on the quartic, which cost little, and then in nine of ten cases a single one on the ring's
/// form.
[[gnu::always_inline]] inline OptionalHit hit_from_outside(const Torus& torus, const Ray& ray,
                                                           double t_max, const Approach& a,
                                                           const Stretch& stretch) {
  const Ring ring(a.line.origin, a.direction, torus);
  const Hole hole = hole_of(ring);
  const double first = hole.holds(stretch.begin) ? hole.exit() : stretch.begin;
  if (!(first < stretch.end)) {
    return {};
  }
  const Quartic quartic = quartic_of(torus, a.line.origin, a.direction);
  double s = first;
  Dip dip = Dip::unclear;
  if (quartic.slope(s) < 0) [[likely]] {
    s = nearer_root(quartic, nearer_root(quartic, s));
    dip = search_dip(ring, s);
    const bool alone = ring.has_one_dip();
    if (!((s > stretch.begin) & (alone | ((s < hole.axis) == (first < hole.axis))))) [[unlikely]] {
      dip = Dip::unclear;
    }
    const double t = a.line.ray_parameter(s * a.per_length);
    if ((dip == Dip::crossed) & (t > 0)) [[likely]] {
      return hit_in_range(t, 0, t_max);
    }
    if ((dip == Dip::missed) & (alone | (first > hole.axis))) {
      return {};
    }
  }
  return hit_by_second_look({torus, ray, a.line, a.direction, a.length},
                            {stretch.begin, stretch.end, hole.axis, hole.exit(), first, s, dip},
                            t_max);
}

/// A ray that starts elsewhere than on the torus, or on it without knowing.
[[gnu::noinline]] OptionalHit hit_from_elsewhere(const Torus& torus, const Ray& ray, double t_max,
                                                 double position_error, double o_dot_d,
                                                 double direction_squared) {
  const Approach a = approach(ray, o_dot_d, direction_squared);
  const Stretch within = within_bounds(torus, a);
  const double origin = a.local(0);
  if (!((origin <= within.end) & (within.begin <= within.end))) {
    return {};
  }
  if (position_error > 0) {
    const Leaving side = coincidence(torus, ray, position_error);
    if (side != Leaving::nothing) {
      return leave_torus(torus, ray, t_max, side);
    }
  }
  const Stretch stretch{std::max(origin, within.begin), std::min(within.end, a.local(t_max))};
  const double sign = origin > within.begin && inside(torus, ray.origin) ? -1 : 1;
  if ((sign < 0) | !has_wide_hole(torus)) {
    return hit_by_quartic({torus, ray, a.line, a.direction, a.length}, stretch, sign, t_max);
  }
  return hit_from_outside(torus, ray, t_max, a, stretch);
}

}  // namespace

OptionalHit intersect(const Torus& shape, const Ray& ray, double t_max, const RayStart& start) {
  const double direction_squared = glm::dot(ray.direction, ray.direction);
  if (start.leaving != Leaving::nothing) {
    return usable(ray, direction_squared) ? leave_torus(shape, ray, t_max, start.leaving)
                                          : OptionalHit{};
  }
  const double o_dot_d = glm::dot(ray.origin, ray.direction);
  if (passes_by(shape, ray.origin, o_dot_d, direction_squared)) {
    return {};
  }
  return hit_from_elsewhere(shape, ray, t_max, start.position_error, o_dot_d, direction_squared);
}

}  // namespace rt
