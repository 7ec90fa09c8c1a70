#pragma once
/// An extended light as a point sees it, and lines across it.
///
/// Directions x X + y Y + Z stand for points (x, y) of a plane at distance 1: there great circles
/// are straight lines, a rectangle parallel to the plane is a rectangle and a sphere about Z a
/// disc. A solid angle is dx dy / (1 + x^2 + y^2)^(3/2).
#include <optional>

#include "rt/math/spherical_rectangle.h"
#include "rt/math/vec.h"
#include "rt/render/planned_light.h"

namespace rt {

/// A straight line across a light: the directions start + s step for lo < s < hi.
class LightLine {
 public:
  /// `start` and the unit vector `step` are perpendicular.
  LightLine(const Vec3& from, const Vec3& unit_step, double low, double high)
      : start(from),
        step(unit_step),
        lo(low),
        hi(high),
        first(low),
        last(high),
        square_(glm::dot(from, from)) {}

  Vec3 start, step;
  double lo, hi;
  double first, last;  ///< what of (lo, hi) stands above horizons

  /// Lowers `last` or raises `first` to where n.direction >= 0.
  void clip(const Vec3& n);

  /// Solid angle from s = 0, in units that are the line's own; of all of the line; the inverse.
  double angle_to(double s) const { return s / std::sqrt(square_ + s * s); }
  double angle() const { return angle_to(hi) - angle_to(lo); }
  double at_angle(double angle) const {
    return angle * std::sqrt(square_ / ((1.0 - angle) * (1.0 + angle)));
  }
  /// The integral of n.l over that angle, from s = 0, l the unit direction.
  double cosine_to(double s, const Vec3& n) const;
  Vec3 direction(double s) const { return glm::normalize(start + s * step); }

 private:
  double square_;  ///< of the length of `start`
};

/// A rectangle as seen through the plane at distance 1. T, V: double and Vec3, or Wide and Wide3.
template <class T, class V>
struct RectangleAhead {
  V z;               ///< unit, towards its plane
  T x0, x1, y0, y1;  ///< on the plane, along its edges
  V mean;            ///< of its unit directions
};

class SeenLight {
 public:
  /// From p; empty for points of light, from inside a sphere, and where digits would be lost: so
  /// close that the light fills half the sky, or all but edge-on.
  static std::optional<SeenLight> from(const Vec3& p, const PlannedLight& light);
  /// What a lane sees of a rectangle; it must be known.
  SeenLight(const WideSphericalRectangle& rectangle, const RectangleAhead<Wide, Wide3>& ahead,
            int lane);

  /// What lies nearer than this along depth_axis() stands before the light.
  double depth() const { return depth_; }
  const Vec3& depth_axis() const { return z_; }
  /// Whether all of the light's directions l have n.l >= 0.
  bool above(const Vec3& n) const;
  /// The mean of max(n.l, 0), uniform in solid angle.
  double mean_cosine(const Vec3& n) const;
  /// No direction of the light has a larger cosine with the unit vector n.
  double largest_cosine(const Vec3& n) const;

  /// A direction, uniform in solid angle.
  Vec3 sample(const Vec2& u) const;
  /// How far away the light is in one of its directions.
  double distance(const Vec3& direction) const;

  /// The middle, as a point of the plane.
  Vec2 middle() const { return middle_; }
  /// A direction (of the light) as a point of the plane.
  Vec2 point_of(const Vec3& direction) const;
  /// The line through a point of the light along the plane's x axis: that of a rectangle's first
  /// edge. (Away from a blocker's middle a sphere's lines scatter 7% less, a rectangle's more; and
  /// what is known of blockers must not decide, bench/NOTES.md.)
  LightLine line(const Vec2& through) const;

 private:
  friend class WideSeenLight;
  SeenLight() = default;
  SeenLight(const SphericalRectangle& rectangle, const RectangleAhead<double, Vec3>& ahead);
  double rectangle_cosine(const Vec3& local) const;
  double disc_cosine(const Vec3& local) const;

  std::optional<SphericalRectangle> rectangle_;  ///< none: a sphere
  Vec3 x_, y_, z_;
  Vec2 lo_{0.0}, hi_{0.0};  ///< of the rectangle
  double radius_ = 0.0;     ///< of the sphere's disc
  double free_ = 0.0;       ///< square of a tangent's length, from p to the sphere
  double far_ = 0.0;        ///< of the sphere's centre
  Vec2 middle_{0.0};
  Vec3 mean_{0.0};
  double depth_ = 0.0;
};

/// The same light from several points, lane by lane.
class WideSeenLight {
 public:
  WideSeenLight(const Wide3& p, const PlannedLight& light);
  std::optional<SeenLight> lane(int i) const;

 private:
  Wide3 p_;
  const PlannedLight& light_;
  std::optional<WideSphericalRectangle> rectangle_;
  RectangleAhead<Wide, Wide3> ahead_;
};

}  // namespace rt
