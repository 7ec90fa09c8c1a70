#pragma once
#include "rt/math/vec.h"

namespace rt {

/// A rectangle seen from a point, sampled uniformly in the solid angle it subtends. Source: Urena,
/// Fajardo, King, "An area-preserving parametrization for spherical rectangles", EGSR 2013; here in
/// a form that keeps its digits for small rectangles (derivation in the .cpp).
///
/// Where that map would lose its digits all the same (p closer to the rectangle's plane than 4e-5
/// of its reach, or a rectangle smaller than 2e-9 of its offset from p's foot), and for a
/// parallelogram, points are drawn uniformly by area. pdf is then the exact density of that, so
/// estimates f / pdf stay unbiased.
class SphericalRectangle {
 public:
  /// Seen from p: corner + s u + t v, s and t in [0,1].
  SphericalRectangle(const Vec3& p, const Vec3& corner, const Vec3& u, const Vec3& v);

  /// Relative error about 1e-14 from 1e-20 to 2 pi; 0 for p in the rectangle's plane.
  double solid_angle() const { return solid_angle_; }

  struct Sample {
    Vec3 to_point;  ///< from p to a point of the rectangle; its length is the distance
    double pdf;     ///< per solid angle; the mean over directions weighs by 1/(pdf solid_angle())
  };
  /// Requires solid_angle() > 0.
  Sample sample(const Vec2& xi) const;

  bool by_area() const { return by_area_; }

  /// The rectangle as x X + y Y + Z about p, in its own unit axes, Z of length 1 towards its plane:
  /// what is seen through the plane at distance 1. Not for by_area().
  struct AtDistance1 {
    Vec3 x, y, z;
    double x0, x1, y0, y1;
  };
  AtDistance1 at_distance_1() const;
  /// Distance of the plane.
  double distance() const { return z_; }

 private:
  bool prepare_map(double height);
  double solid_angle_by_triangles() const;
  Sample sample_area(const Vec2& xi) const;

  Vec3 corner_, u_, v_, normal_;  ///< the corner relative to p; the edges; unit normal
  Vec3 x_, y_;                    ///< unit edges
  double x0_, x1_, y0_, y1_;      ///< the rectangle in that basis, about p's foot
  double z_;                      ///< distance of the plane, >= 0
  double area_;
  double solid_angle_;
  bool by_area_;
  double delta0_, delta1_;  ///< pi minus the angle of the x = x0 and the x = x1 end
  double p0_, p1_;          ///< sines of the elevations of the y = y0 and y = y1 edges
};

}  // namespace rt
