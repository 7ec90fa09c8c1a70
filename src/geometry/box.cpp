#include "rt/geometry/box.h"

#include "convex.h"
#include "rt/geometry/exact.h"
#include "rt/math/rounding.h"

namespace rt {
namespace {

Vec3 axis_vector(int axis, double length) {
  Vec3 v(0.0);
  v[axis] = length;
  return v;
}

std::uint32_t face(int axis, bool high) { return 2 * static_cast<std::uint32_t>(axis) + high; }

/// The exact order of (from_i - o_i) / d_i and (to_j - o_j) / d_j: multiplied out, with the
/// differences kept exact, so that only terms of the order of u^2 are rounded.
bool enters_before(const Box& shape, const Ray& ray, int i, int j) {
  const Vec3& o = ray.origin;
  const Vec3& d = ray.direction;
  const DoublePair from =
      exact_difference(d[i] > 0 ? shape.lo[i] : -shape.hi[i], d[i] > 0 ? o[i] : -o[i]);
  const DoublePair to =
      exact_difference(d[j] > 0 ? shape.hi[j] : -shape.lo[j], d[j] > 0 ? o[j] : -o[j]);
  const double di = std::abs(d[i]);
  const double dj = std::abs(d[j]);
  return difference_of_products(from.high, dj, to.high, di) + (from.low * dj - to.low * di) <= 0;
}

/// A ray past an edge or a corner: entry and exit too close for their rounded values to tell.
bool crosses_edge(const Box& shape, const Ray& ray) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const bool slanted = i != j && ray.direction[i] != 0 && ray.direction[j] != 0;
      if (slanted && !enters_before(shape, ray, i, j)) {
        return false;
      }
    }
  }
  return true;
}

OptionalHit leave_box(const Box& shape, const Ray& ray, double t_max) {
  Chord chord;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    if (d != 0) {  // either sign of zero: parallel to the slab, never leaves through it
      const double out = ((d > 0 ? shape.hi[axis] : shape.lo[axis]) - ray.origin[axis]) / d;
      chord.clip(-infinity, 0, out, face(axis, d > 0));
    }
  }
  return exit_hit(chord.t_out, chord.out, t_max);
}

/// The side to which the ray leaves, if its origin lies on the box within `error`. Distances to
/// faces are single differences, exact near the faces: no rounding of our own to add.
Leaving coincidence(const Box& shape, const Ray& ray, double error) {
  Touching touching;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis];
    const double d = ray.direction[axis];
    if (!(o >= shape.lo[axis] - error && o <= shape.hi[axis] + error)) {
      return Leaving::nothing;
    }
    touching.face(std::abs(o - shape.lo[axis]) <= error, -d);
    touching.face(std::abs(o - shape.hi[axis]) <= error, d);
  }
  return touching.side();
}

}  // namespace

OptionalHit intersect(const Box& shape, const Ray& ray, double t_max, const RayStart& start) {
  if (start.leaving == Leaving::outward || !usable(ray, glm::dot(ray.direction, ray.direction))) {
    return {};
  }
  if (start.leaving == Leaving::inward) {
    return leave_box(shape, ray, t_max);
  }
  Chord chord;
  for (int axis = 0; axis < 3; ++axis) {
    chord.clip_slab(ray.origin[axis], ray.direction[axis], shape.lo[axis], face(axis, false),
                    shape.hi[axis], face(axis, true));
  }
  // Each bound carries a rounded difference and a rounded quotient.
  const double slack = gamma(2) * (std::abs(chord.t_in) + std::abs(chord.t_out));
  if (!(chord.t_in <= chord.t_out + slack)) {
    return {};
  }
  if (chord.t_in >= chord.t_out - slack) {
    if (!crosses_edge(shape, ray)) {
      return {};
    }
    chord.t_out = std::max(chord.t_out, chord.t_in);
  }
  if (start.position_error > 0) {
    const Leaving side = coincidence(shape, ray, start.position_error);
    if (side != Leaving::nothing) {
      return side == Leaving::inward ? leave_box(shape, ray, t_max) : OptionalHit{};
    }
  }
  return first_hit(chord, t_max);
}

SurfacePoint surface_point(const Box& shape, const Ray& ray, const ShapeHit& hit) {
  const int axis = static_cast<int>(hit.feature / 2);
  const bool high = hit.feature % 2 == 1;
  Vec3 p = glm::clamp(fused_at(ray.origin, ray.direction, hit.t), shape.lo, shape.hi);
  p[axis] = high ? shape.hi[axis] : shape.lo[axis];
  const Vec3 normal = axis_vector(axis, high ? 1 : -1);
  return {p, normal, normal};
}

/// Each face is seen from outside, unmirrored: v is up (+y) on the sides, -z on the top and +z on
/// the bottom face; u is to the right.
SurfaceCoordinates surface_coordinates(const Box& shape, const SurfacePoint& point,
                                       std::uint32_t feature) {
  const int axis = static_cast<int>(feature / 2);
  const double side = feature % 2 == 1 ? 1 : -1;
  const int u_axis = axis == 0 ? 2 : 0;
  const int v_axis = axis == 1 ? 2 : 1;
  const double u_sign = axis == 0 ? -side : (axis == 1 ? 1 : side);
  const double v_sign = axis == 1 ? -side : 1;
  const Vec3 extent = shape.hi - shape.lo;
  const auto fraction = [&](int i, double sign) {
    if (!(extent[i] > 0)) {
      return 0.5;  // rounded away: a size below the last place of the corner
    }
    return (sign > 0 ? point.position[i] - shape.lo[i] : shape.hi[i] - point.position[i]) /
           extent[i];
  };
  return {{fraction(u_axis, u_sign), fraction(v_axis, v_sign)},
          axis_vector(u_axis, u_sign * extent[u_axis]),
          axis_vector(v_axis, v_sign * extent[v_axis])};
}

Vec3 normal_change(const Box&, const SurfacePoint&, std::uint32_t, const Vec3&) {
  return Vec3(0.0);
}

Bounds bounds(const Box& shape) { return {shape.lo, shape.hi}; }

}  // namespace rt
