#include "rt/geometry/wide_shapes.h"

#include "convex.h"
#include "rt/math/rounding.h"

namespace rt {
namespace {

WideMask in_range(const Wide& t, const Wide& t_max) {
  return t > 0.0 && t <= t_max && t < infinity;
}

/// As first_hit(): the first end of a chord ahead of the origin.
[[gnu::always_inline]] inline WideHit first_end(const WideMask& crossed, const WideMask& undecided,
                                                const Wide& t_in, const Wide& in, const Wide& t_out,
                                                const Wide& out, const Wide& t_max) {
  const WideMask ahead = t_in > 0.0;
  const Wide t = select(ahead, t_in, t_out);
  return {crossed && !undecided && t_in <= t_out && in_range(t, t_max), undecided, t,
          select(ahead, in, out)};
}

/// A line seen from its point nearest to the model's origin: as Recentred.
struct WideRecentred {
  Wide3 origin;
  Wide shift, residual;

  Wide ray_parameter(const Wide& s) const { return shift + (residual + s); }
};

[[gnu::always_inline]] inline WideRecentred recentred(const Wide3& origin, const Wide3& direction,
                                                      const Wide& direction_squared) {
  const Wide scale = -1.0 / direction_squared;
  const Wide shift = dot(origin, direction) * scale;
  const Wide3 near = fused_at(origin, direction, shift);
  const Wide residual = dot(near, direction) * scale;
  return {fused_at(near, direction, residual), shift, residual};
}

struct WidePair {
  Wide high, low;
};

WidePair exact_difference(const Wide& a, const Wide& b) {
  const Wide high = a - b;
  const Wide b_part = a - high;
  const Wide a_part = high + b_part;
  return {high, (a - a_part) + (b_part - b)};
}

Wide difference_of_products(const Wide& a, const Wide& b, const Wide& c, const Wide& d) {
  const Wide cd = c * d;
  const Wide error = fma(-c, d, cd);
  return fma(a, b, -cd) + error;
}

struct FromCentre {
  Wide3 origin, lost;
};

[[gnu::always_inline]] inline FromCentre from_centre(const Sphere& shape, const WideRay& ray) {
  const WidePair x = exact_difference(ray.origin.x, shape.centre.x);
  const WidePair y = exact_difference(ray.origin.y, shape.centre.y);
  const WidePair z = exact_difference(ray.origin.z, shape.centre.z);
  return {{x.high, y.high, z.high}, {x.low, y.low, z.low}};
}

/// A part of lines in a convex solid, and the features they cross: as Chord.
struct WideChord {
  Wide t_in{-infinity};
  Wide t_out{infinity};
  Wide in{0.0};
  Wide out{0.0};
  WideMask outside{false};

  void clip(const WideMask& where, const Wide& t0, const Wide& feature0, const Wide& t1,
            const Wide& feature1) {
    const WideMask first = where && t0 > t_in;
    t_in = select(first, t0, t_in);
    in = select(first, feature0, in);
    const WideMask second = where && t1 < t_out;
    t_out = select(second, t1, t_out);
    out = select(second, feature1, out);
  }

  void clip_slab(const Wide& origin, const Wide& direction, double lo, double lo_feature, double hi,
                 double hi_feature) {
    const WideMask rising = direction > 0.0;
    const WideMask slanted = rising || direction < 0.0;
    const Wide near = select(rising, Wide(lo), Wide(hi));
    const Wide far = select(rising, Wide(hi), Wide(lo));
    clip(slanted, (near - origin) / direction, select(rising, Wide(lo_feature), Wide(hi_feature)),
         (far - origin) / direction, select(rising, Wide(hi_feature), Wide(lo_feature)));
    outside = outside || (!slanted && !(origin >= lo && origin <= hi));
  }
};

WideMask usable(const WideRay& ray, const Wide& direction_squared) {
  return direction_squared > 0.0 && direction_squared + dot(ray.origin, ray.origin) < infinity;
}

struct PlaneMeeting {
  WideMask met;
  Wide t;
};

PlaneMeeting meet_plane(const WideRay& ray, const Wide& t_max, const Wide& position_error) {
  const WideMask left = position_error > 0.0 && abs(ray.origin.y) <= position_error;
  const Wide t = -ray.origin.y / ray.direction.y;
  return {!left && in_range(t, t_max), t};
}

WideSurfacePoint point_of_plane(const WideRay& ray, const Wide& t) {
  Wide3 p = fused_at(ray.origin, ray.direction, t);
  p.y = 0.0;
  return {p, Vec3(0, 1, 0)};
}

WideMask within(const Wide& origin, const Wide& direction, const Wide& y, const Wide& dy,
                double half) {
  return abs(difference_of_products(origin, dy, y, direction)) <= half * abs(dy);
}

Wide clamp(const Wide& x, double lo, double hi) { return min(max(x, Wide(lo)), Wide(hi)); }

}  // namespace

WideMask may_meet(const Bounds& box, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error) {
  // Recentring moves a line by a few roundings of its origin, solving it by a few of the shape.
  const Wide room = gamma(64) * (max_abs(ray.origin) + std::max(max_abs(box.lo), max_abs(box.hi))) +
                    position_error;
  Wide t_in(0.0);
  Wide t_out = t_max;
  const auto clip = [&](const Wide& origin, const Wide& direction, double lo, double hi) {
    const Wide inverse = 1.0 / direction;
    const Wide a = (lo - room - origin) * inverse;
    const Wide b = (hi + room - origin) * inverse;
    t_in = max(t_in, min(a, b));  // a NaN, where origin and face agree, clips nothing
    t_out = min(t_out, max(a, b));
  };
  clip(ray.origin.x, ray.direction.x, box.lo.x, box.hi.x);
  clip(ray.origin.y, ray.direction.y, box.lo.y, box.hi.y);
  clip(ray.origin.z, ray.direction.z, box.lo.z, box.hi.z);
  // Each bound carries two rounded differences, a quotient and a product.
  return !(t_in > t_out + gamma(8) * (abs(t_in) + abs(t_out)));
}

WideHit intersect(const Sphere& shape, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error) {
  const Wide direction_squared = dot(ray.direction, ray.direction);
  const FromCentre from = from_centre(shape, ray);
  WideRecentred line = recentred(from.origin, ray.direction, direction_squared);
  line.origin += from.lost;
  const double square = shape.radius * shape.radius;
  const Wide chord = square - dot(line.origin, line.origin);
  WideMask undecided = abs(chord) <= 2 * gamma(6) * square;
  const WideMask crossed = chord >= 0.0;
  if (!any(crossed || undecided)) {
    return {WideMask(false), WideMask(false), Wide(0.0), Wide(0.0)};
  }
  if (any(position_error > 0.0)) {  // where the origin may lie on the sphere
    const Wide distance_squared = dot(from.origin, from.origin);
    const Wide off = abs(distance_squared - square);
    undecided =
        undecided || (crossed && off <= position_error * (2 * shape.radius + position_error) +
                                            gamma(6) * (distance_squared + square));
  }
  const Wide half = sqrt(chord / direction_squared);
  return first_end(crossed, undecided, line.ray_parameter(-half), 0.0, line.ray_parameter(half),
                   0.0, t_max);
}

WideHit leave_inward(const Sphere& shape, const WideRay& ray, const Wide& t_max) {
  const Wide t =
      -2 * dot(from_centre(shape, ray).origin, ray.direction) / dot(ray.direction, ray.direction);
  const Wide out = select(t <= 0.0, Wide(std::numeric_limits<double>::min()), t);
  return {in_range(out, t_max), WideMask(false), out, Wide(0.0)};
}

WideHit intersect(const Plane&, const WideRay& ray, const Wide& t_max, const Wide& position_error) {
  const PlaneMeeting meeting = meet_plane(ray, t_max, position_error);
  return {meeting.met, WideMask(false), meeting.t, Wide(0.0)};
}

WideHit intersect(const Square& shape, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error) {
  const PlaneMeeting meeting = meet_plane(ray, t_max, position_error);
  const Wide3& o = ray.origin;
  const Wide3& d = ray.direction;
  const double half = shape.edge / 2;
  return {meeting.met && within(o.x, d.x, o.y, d.y, half) && within(o.z, d.z, o.y, d.y, half),
          WideMask(false), meeting.t, Wide(0.0)};
}

WideHit intersect(const Box& shape, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error) {
  const Wide3& o = ray.origin;
  const Wide3& d = ray.direction;
  WideChord chord;
  chord.clip_slab(o.x, d.x, shape.lo.x, 0.0, shape.hi.x, 1.0);
  chord.clip_slab(o.y, d.y, shape.lo.y, 2.0, shape.hi.y, 3.0);
  chord.clip_slab(o.z, d.z, shape.lo.z, 4.0, shape.hi.z, 5.0);
  const Wide slack = gamma(2) * (abs(chord.t_in) + abs(chord.t_out));
  const WideMask crossed =
      chord.t_in <= chord.t_out + slack && !chord.outside && usable(ray, dot(d, d));
  WideMask undecided = crossed && chord.t_in >= chord.t_out - slack;
  if (any(crossed) && any(position_error > 0.0)) {  // where the origin may lie on the box
    WideMask inside(true);
    WideMask near(false);
    const auto look = [&](const Wide& at, double lo, double hi) {
      inside = inside && at >= lo - position_error && at <= hi + position_error;
      near = near || abs(at - lo) <= position_error || abs(at - hi) <= position_error;
    };
    look(o.x, shape.lo.x, shape.hi.x);
    look(o.y, shape.lo.y, shape.hi.y);
    look(o.z, shape.lo.z, shape.hi.z);
    undecided = undecided || (crossed && inside && near);
  }
  return first_end(crossed, undecided, chord.t_in, chord.in, chord.t_out, chord.out, t_max);
}

WideHit intersect(const Cylinder&, const WideRay& ray, const Wide& t_max,
                  const Wide& position_error) {
  constexpr double side = 0.0;
  const Wide3& d = ray.direction;
  const Wide direction_squared = dot(d, d);
  const WideMask good = usable(ray, direction_squared);
  const WideRecentred line = recentred(ray.origin, d, direction_squared);
  const Wide across = d.x * d.x + d.z * d.z;
  const Wide middle = -(line.origin.x * d.x + line.origin.z * d.z) / across;
  const Wide x = fma(middle, d.x, line.origin.x);
  const Wide z = fma(middle, d.z, line.origin.z);
  const Wide square = 1 - (x * x + z * z);
  WideMask undecided = !(across > 0.0) || abs(square) <= gamma(12);
  const Wide half = sqrt(square / across);
  WideChord chord;
  chord.clip(half >= 0.0, middle - half, side, middle + half, side);
  chord.clip_slab(line.origin.y, d.y, 0, 1.0, 1, 2.0);
  const WideMask crossed = good && half >= 0.0 && !chord.outside && chord.t_in <= chord.t_out;
  undecided = good && undecided;
  if (any(crossed) && any(position_error > 0.0)) {  // where the origin may lie on the cylinder
    const Wide3& o = ray.origin;
    const Wide radius = sqrt(o.x * o.x + o.z * o.z);
    const Wide radial_error = position_error + gamma(3) * radius;
    const WideMask inside =
        radius <= 1 + radial_error && o.y >= -position_error && o.y <= 1 + position_error;
    const WideMask near = abs(radius - 1) <= radial_error || abs(o.y) <= position_error ||
                          abs(o.y - 1) <= position_error;
    undecided = undecided || (crossed && inside && near);
  }
  return first_end(crossed, undecided, line.ray_parameter(chord.t_in), chord.in,
                   line.ray_parameter(chord.t_out), chord.out, t_max);
}

WideSurfacePoint surface_point(const Sphere& shape, const WideRay& ray, const Wide& t,
                               const Wide&) {
  const FromCentre from = from_centre(shape, ray);
  const Wide3 normal = normalize(fused_at(from.origin, ray.direction, t) + from.lost);
  return {Wide3(shape.centre) + Wide(shape.radius) * normal, normal};
}

WideSurfacePoint surface_point(const Plane&, const WideRay& ray, const Wide& t, const Wide&) {
  return point_of_plane(ray, t);
}

WideSurfacePoint surface_point(const Square&, const WideRay& ray, const Wide& t, const Wide&) {
  return point_of_plane(ray, t);
}

WideSurfacePoint surface_point(const Box& shape, const WideRay& ray, const Wide& t,
                               const Wide& feature) {
  const Wide3 at = fused_at(ray.origin, ray.direction, t);
  const auto placed = [&](const Wide& p, double lo, double hi, double face) {
    return select(feature == face, Wide(lo),
                  select(feature == face + 1.0, Wide(hi), clamp(p, lo, hi)));
  };
  const auto normal = [&](double face) {
    return select(feature == face, Wide(-1.0), select(feature == face + 1.0, Wide(1.0), Wide(0.0)));
  };
  return {{placed(at.x, shape.lo.x, shape.hi.x, 0.0), placed(at.y, shape.lo.y, shape.hi.y, 2.0),
           placed(at.z, shape.lo.z, shape.hi.z, 4.0)},
          {normal(0.0), normal(2.0), normal(4.0)}};
}

WideSurfacePoint surface_point(const Cylinder&, const WideRay& ray, const Wide& t,
                               const Wide& feature) {
  const Wide3 p = fused_at(ray.origin, ray.direction, t);
  const Wide radius = sqrt(p.x * p.x + p.z * p.z);
  const WideMask off_axis = radius > 0.0;
  const Wide cosine = select(off_axis, p.x / radius, Wide(1.0));
  const Wide sine = select(off_axis, p.z / radius, Wide(0.0));
  const WideMask side = feature == 0.0;
  const WideMask top = feature == 2.0;
  const Wide cap = select(top, Wide(1.0), Wide(0.0));
  return {
      {select(side, cosine, p.x), select(side, clamp(p.y, 0.0, 1.0), cap), select(side, sine, p.z)},
      {select(side, cosine, Wide(0.0)), select(side, Wide(0.0), select(top, Wide(1.0), Wide(-1.0))),
       select(side, sine, Wide(0.0))}};
}

Wide3 normal_change(const Sphere& shape, const WideSurfacePoint&, const Wide&, const Wide3& step) {
  return step / Wide(shape.radius);
}
Wide3 normal_change(const Plane&, const WideSurfacePoint&, const Wide&, const Wide3&) {
  return Wide3(Wide(0.0));
}
Wide3 normal_change(const Square&, const WideSurfacePoint&, const Wide&, const Wide3&) {
  return Wide3(Wide(0.0));
}
Wide3 normal_change(const Box&, const WideSurfacePoint&, const Wide&, const Wide3&) {
  return Wide3(Wide(0.0));
}
Wide3 normal_change(const Cylinder&, const WideSurfacePoint&, const Wide& feature,
                    const Wide3& step) {
  const WideMask side = feature == 0.0;
  return {select(side, step.x, Wide(0.0)), Wide(0.0), select(side, step.z, Wide(0.0))};
}

}  // namespace rt
