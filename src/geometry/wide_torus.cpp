#include "convex.h"
#include "rt/geometry/wide_shapes.h"
#include "torus_dips.h"
#include "torus_quartic.h"

/// The way of most rays to a torus, several at a time: operation by operation that of
/// torus_intersect.cpp. Whatever goes another way there is left undecided here.
namespace rt {
namespace {

using WideRing = RingAlongLine<Wide, Wide3>;

/// As step_to_root() for one.
RingStep<Wide> step_to_root(const RingJet<Wide>& jet) {
  const Wide discriminant = jet.discriminant();
  const WideMask real = discriminant >= 0.0;
  const Wide fall = sqrt(select(real, discriminant, Wide(0.0)));
  const WideMask falling = real && jet.slope < 0.0;
  return {select(falling, 2 * jet.value, -(jet.slope + fall)) /
              select(falling, fall - jet.slope, jet.curvature),
          fall};
}

Wide nearer_root(const QuarticOf<Wide>& quartic, const Wide& s) {
  const Wide value = quartic(s);
  const Wide slope = quartic.slope(s);
  const Wide square = slope * slope;
  const Wide bend = value * quartic.curvature(s);
  return s - slope * value / select(bend > shallow * square, bend, square - 0.5 * bend);
}

struct WideDip {
  WideMask crossed, missed;
};

/// As search_dip() for one, in the lanes of `open`; touched and unclear ones are in neither.
WideDip search_dip(const WideRing& ring, Wide& s, WideMask open) {
  constexpr int most_steps = 8;
  const double size2 = ring.size() * ring.size();
  WideDip dip{WideMask(false), WideMask(false)};
  for (int i = 0; i < most_steps && any(open); ++i) {
    const RingJet<Wide> jet = ring.at(s);
    open = open && 16 * jet.square >= size2 && jet.square <= 2 * size2 && jet.curvature > 0.0;
    const Wide doubt = 4 * ring.noise() * jet.curvature;
    const Wide discriminant = jet.discriminant();
    const WideMask lowest = open && discriminant <= doubt && is_near_lowest(ring, jet);
    if (any(lowest)) {
      const WideMask missed =
          lowest && (jet.value - ring.noise()) * jet.curvature > jet.slope * jet.slope;
      dip.missed = dip.missed || missed;
      open = open && !missed && !(lowest && discriminant >= -doubt);
    }
    const RingStep<Wide> step = step_to_root(jet);
    s = select(open, s + step.length, s);
    const WideMask done = open && settled(ring, jet, step);
    dip.crossed =
        dip.crossed || (done && step.fall > ring.slope_noise() && step.fall * step.fall > doubt);
    open = open && !done;
  }
  return dip;
}

/// Lanes whose origin may lie on the torus, for all that is known of it: twice what the test of one
/// ray accepts, and however far its sheets are apart.
WideMask may_coincide(const Torus& torus, const Wide3& o, const Wide& error) {
  const Wide w = sqrt(o.x * o.x + o.z * o.z) - torus.major_radius;
  const Wide off = abs(sqrt(w * w + o.y * o.y) - torus.minor_radius);
  return off <= 2.0 * (error + gamma(7) * (length(o) + torus.major_radius));
}

Wide factor(const Torus& torus, const Wide& rho, const Wide& y, double sheet) {
  const Wide w = rho - sheet * torus.major_radius;
  const double r = torus.minor_radius;
  return w * w + (y - r) * (y + r);
}

WideMask inside(const Torus& torus, const Wide3& p) {
  const Wide rho = sqrt(p.x * p.x + p.z * p.z);
  return (factor(torus, rho, p.y, 1) < 0.0) != (factor(torus, rho, p.y, -1) < 0.0);
}

/// As Approach and Stretch: lines from their points nearest to the centre, by arc length, and where
/// they are inside the bounding sphere and slab.
struct WideApproach {
  Wide3 o, d;
  Wide shift, residual, length, per_length;
  Wide begin, end;

  Wide local(const Wide& t) const { return ((t - shift) - residual) * length; }
};

WideApproach approach(const Torus& torus, const WideRay& ray, const Wide& o_dot_d,
                      const Wide& direction_squared) {
  WideApproach a;
  a.length = sqrt(direction_squared);
  const Wide scale = -1 / direction_squared;
  a.shift = o_dot_d * scale;
  const Wide3 near = fused_at(ray.origin, ray.direction, a.shift);
  const Wide along = dot(near, ray.direction);
  a.residual = along * scale;
  a.per_length = -scale * a.length;
  const Wide near_square = dot(near, near);
  const Wide square = near_square + along * a.residual;
  const Wide slack = 16 * unit_roundoff * near_square;
  a.o = fused_at(near, ray.direction, a.residual);
  a.d = ray.direction * a.per_length;
  const double size = size_of(torus);
  const Wide half = sqrt(size * size * (1 + 16 * unit_roundoff) + slack - square);
  const double thickness = torus.minor_radius + 16 * unit_roundoff * size;
  const Wide per_y = 1 / a.d.y;
  const Wide lower = (-thickness - a.o.y) * per_y;
  const Wide upper = (thickness - a.o.y) * per_y;
  a.begin = max(-half, min(lower, upper));
  a.end = min(half, max(lower, upper));
  return a;
}

/// As hit_from_outside(), in the lanes of `open`.
WideHit hit_from_outside(const Torus& torus, const WideApproach& a, WideMask open,
                         const Wide& t_max) {
  const Wide origin = a.local(Wide(0.0));
  const Wide begin = max(origin, a.begin);
  const Wide end = min(a.end, a.local(t_max));
  const WideRing ring(a.o, a.d, torus);
  const double inner = ring.R - ring.r;
  const Wide c = ring.o.x * ring.o.x + ring.o.z * ring.o.z;
  const Wide per_k = 1 / ring.k;
  const Wide axis = -ring.b * per_k;
  const Wide half =
      sqrt(ring.b * ring.b - ring.k * (c - inner * inner * (1 - 64 * unit_roundoff))) * per_k;
  const Wide first = select(abs(begin - axis) < half, axis + half, begin);
  open = open && first < end;
  const QuarticOf<Wide> quartic = quartic_of(torus, a.o, a.d, dot(a.o, a.o));
  const WideMask falling = open && quartic.slope(first) < 0.0;
  Wide s = nearer_root(quartic, nearer_root(quartic, first));
  const WideDip dip = search_dip(ring, s, falling);
  const WideMask alone = ring.has_one_dip();
  const WideMask clear = falling && s > begin && (alone || (s < axis) == (first < axis));
  const Wide t = a.shift + (a.residual + s * a.per_length);
  const WideMask crossed = clear && dip.crossed && t > 0.0;
  const WideMask missed = clear && dip.missed && (alone || first > axis);
  return {crossed && t <= t_max && t < infinity, open && !crossed && !missed, t, Wide(0.0)};
}

}  // namespace

WideHit intersect(const Torus& torus, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error) {
  const Wide direction_squared = dot(ray.direction, ray.direction);
  const Wide o_dot_d = dot(ray.origin, ray.direction);
  const double size = size_of(torus);
  const Wide outside = dot(ray.origin, ray.origin) * (1 - 24 * unit_roundoff) -
                       size * size * (1 + 16 * unit_roundoff);
  WideMask open = !(outside * direction_squared > o_dot_d * o_dot_d);
  if (!any(open)) {
    return {WideMask(false), WideMask(false), Wide(0.0), Wide(0.0)};
  }
  const WideApproach a = approach(torus, ray, o_dot_d, direction_squared);
  const Wide origin = a.local(Wide(0.0));
  open = open && origin <= a.end && a.begin <= a.end;
  if (!any(open) || !has_wide_hole(torus)) {
    return {WideMask(false), open, Wide(0.0), Wide(0.0)};
  }
  WideMask undecided(false);
  if (any(position_error > 0.0)) {
    undecided = open && may_coincide(torus, ray.origin, position_error);
  }
  const WideMask begins_within = open && origin > a.begin;
  if (any(begins_within)) {
    undecided = undecided || (begins_within && inside(torus, ray.origin));
  }
  WideHit found = hit_from_outside(torus, a, open && !undecided, t_max);
  found.undecided = found.undecided || undecided;
  return found;
}

// Divided by its root at the start, the quartic is a cubic: torus_leaving.cpp. Where that stays above
// all rounding up to its lowest place ahead, there is no other root; what happens within a tube's
// radius of the start does not depend on rounding there, and from there on the cubic is at least
// what it is there or at its lowest.
WideMask leaves_for_good(const Torus& shape, const WideRay& ray) {
  if (!has_wide_hole(shape)) {
    return WideMask(false);
  }
  const Wide3& o = ray.origin;
  CubicOf<Wide> cubic = cubic_of(shape, o, ray.direction * (1.0 / length(ray.direction)),
                                 sqrt(o.x * o.x + o.z * o.z), 1.0);
  cubic.c0 = max(cubic.c0, Wide(0.0));
  const Wide discriminant = cubic.c2 * cubic.c2 - 3 * cubic.c1;
  const Wide lowest = (sqrt(max(discriminant, Wide(0.0))) - cubic.c2) * (1.0 / 3);
  const Wide s =
      select(discriminant >= 0.0 && lowest > 0.0, lowest, Wide(shape.minor_radius));
  const double size = size_of(shape);
  return cubic(s) > 2 * polynomial_noise * size * size * size;
}

namespace {

/// As Meridian and sheet_at(), of several points.
struct WideSheet {
  Wide radius, cosine, sine;
  Wide sheet;

  WideSheet(const Torus& shape, const Wide3& p) {
    const Wide rho = sqrt(p.x * p.x + p.z * p.z);
    const WideMask off_axis = rho > 0.0;
    radius = select(off_axis, rho, Wide(0.0));
    cosine = select(off_axis, p.x / rho, Wide(1.0));
    sine = select(off_axis, p.z / rho, Wide(0.0));
    const WideMask apple =
        abs(factor(shape, radius, p.y, 1)) <= abs(factor(shape, radius, p.y, -1));
    sheet = select(apple, Wide(1.0), Wide(-1.0));
  }
};

}  // namespace

WideSurfacePoint surface_point(const Torus& shape, const WideRay& ray, const Wide& t, const Wide&) {
  const Wide3 p = fused_at(ray.origin, ray.direction, t);
  const WideSheet m(shape, p);
  const Wide w = m.radius - m.sheet * shape.major_radius;
  const Wide length = sqrt(w * w + p.y * p.y);
  const WideMask off_ring = length > 0.0;
  const Wide cosine = select(off_ring, w / length, Wide(1.0));
  const Wide sine = select(off_ring, p.y / length, Wide(0.0));
  const Wide radius = m.sheet * shape.major_radius + shape.minor_radius * cosine;
  return {{radius * m.cosine, shape.minor_radius * sine, radius * m.sine},
          m.sheet * Wide3(cosine * m.cosine, sine, cosine * m.sine)};
}

Wide3 normal_change(const Torus& shape, const WideSurfacePoint& point, const Wide&,
                    const Wide3& step) {
  const Wide3& p = point.position;
  const WideSheet m(shape, p);
  const Wide R = m.sheet * shape.major_radius;
  const Wide3 along(-m.sine, Wide(0.0), m.cosine);
  const Wide turn = select(m.radius > 0.0, dot(step, along) / m.radius, Wide(0.0));
  const Wide3 from_ring = p - R * Wide3(m.cosine, Wide(0.0), m.sine);
  const Wide3 change = (step - R * turn * along) / Wide(shape.minor_radius);
  return select(dot(from_ring, point.normal) < 0.0, -change, change);
}

}  // namespace rt
