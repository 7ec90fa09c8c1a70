#pragma once
#include <cmath>
#include <limits>

#include "recentre.h"
#include "rt/geometry/hit.h"

namespace rt {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// The part t_in <= t <= t_out of a line that lies in a convex solid, and the features it crosses.
struct Chord {
  double t_in = -infinity;
  double t_out = infinity;
  std::uint32_t in = 0;
  std::uint32_t out = 0;

  bool empty() const { return !(t_in <= t_out); }

  /// Cuts the chord down to what also lies in [t0, t1].
  void clip(double t0, std::uint32_t feature0, double t1, std::uint32_t feature1) {
    if (t0 > t_in) {
      t_in = t0;
      in = feature0;
    }
    if (t1 < t_out) {
      t_out = t1;
      out = feature1;
    }
  }

  /// Cuts the chord down to the slab lo <= origin + t * direction <= hi of one coordinate.
  void clip_slab(double origin, double direction, double lo, std::uint32_t lo_feature, double hi,
                 std::uint32_t hi_feature) {
    if (direction > 0) {
      clip((lo - origin) / direction, lo_feature, (hi - origin) / direction, hi_feature);
    } else if (direction < 0) {
      clip((hi - origin) / direction, hi_feature, (lo - origin) / direction, lo_feature);
    } else if (!(origin >= lo && origin <= hi)) {
      t_out = -infinity;
      t_in = infinity;
    }
  }
};

inline OptionalHit hit_in_range(double t, std::uint32_t feature, double t_max) {
  if (t > 0 && t <= t_max && t < infinity) {
    return ShapeHit{t, feature};
  }
  return {};
}

/// Where a ray that has just entered a convex solid comes out. It always does: an exit that
/// rounding puts at or before the entry is reported at the smallest positive t, for otherwise a ray
/// that crosses a solid's very edge would stay inside for ever.
inline OptionalHit exit_hit(double t, std::uint32_t feature, double t_max) {
  return hit_in_range(t <= 0 ? std::numeric_limits<double>::min() : t, feature, t_max);
}

/// The first end of the chord ahead of a ray that starts on no surface.
inline OptionalHit first_hit(const Chord& chord, double t_max) {
  if (chord.empty()) {
    return {};
  }
  return chord.t_in > 0 ? hit_in_range(chord.t_in, chord.in, t_max)
                        : hit_in_range(chord.t_out, chord.out, t_max);
}

/// The chord of two parts, each convex, whose union is too: the line runs through one part, crosses
/// the plane of the join and runs through the other. The join itself is never an end of the chord,
/// so there is no seam to fall through or to hit twice.
inline Chord joined(const Chord& first, const Chord& second) {
  if (first.empty()) {
    return second;
  }
  if (second.empty()) {
    return first;
  }
  return {first.t_in, second.t_out, first.in, second.out};
}

/// Collects the faces of a convex solid that pass within the position error of a ray's origin. The
/// ray goes in only if it passes to the inner side of every one of them.
class Touching {
 public:
  void face(bool near, double normal_dot_direction) {
    any_ = any_ || near;
    inward_ = inward_ && (!near || normal_dot_direction < 0);
  }
  Leaving side() const {
    if (!any_) {
      return Leaving::nothing;
    }
    return inward_ ? Leaving::inward : Leaving::outward;
  }

 private:
  bool any_ = false;
  bool inward_ = true;
};

/// A ray that starts on a solid, as far as arithmetic can tell: to which side it leaves, and what.
struct Coincidence {
  Leaving side;
  std::uint32_t feature;
};

/// False for a ray with a NaN or an infinity in it, or without a direction.
inline bool usable(const Ray& ray, double direction_squared) {
  return direction_squared > 0 && direction_squared + glm::dot(ray.origin, ray.origin) < infinity;
}

/// What a ray meets of a convex solid, by three answers that the solid gives:
///
///   Chord chord_of(const S&, const Ray&, const Recentred& line, double direction_squared)
///       The part of the line that lies in it, in the line's local parameter.
///   Coincidence coincidence(const S&, const Ray&, double error)
///       The side to which the ray leaves, if its origin lies on the surface within `error`.
///   OptionalHit leave(const S&, const Ray&, double t_max, std::uint32_t feature)
///       Where a ray that starts on that feature, going inward, comes out.
template <auto chord_of, auto coincidence, auto leave, class S>
OptionalHit intersect_convex(const S& shape, const Ray& ray, double t_max, const RayStart& start) {
  const double direction_squared = glm::dot(ray.direction, ray.direction);
  if (start.leaving == Leaving::outward || !usable(ray, direction_squared)) {
    return {};
  }
  if (start.leaving == Leaving::inward) {
    return leave(shape, ray, t_max, start.feature);
  }
  const Recentred line = recentred(ray.origin, ray.direction, direction_squared);
  Chord chord = chord_of(shape, ray, line, direction_squared);
  if (chord.empty()) {
    return {};
  }
  if (start.position_error > 0) {
    const auto [side, feature] = coincidence(shape, ray, start.position_error);
    if (side != Leaving::nothing) {
      return side == Leaving::inward ? leave(shape, ray, t_max, feature) : OptionalHit{};
    }
  }
  chord.t_in = line.ray_parameter(chord.t_in);
  chord.t_out = line.ray_parameter(chord.t_out);
  return first_hit(chord, t_max);
}

}  // namespace rt
