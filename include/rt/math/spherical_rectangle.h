#pragma once
#include "rt/math/wide.h"

namespace rt {

/// What a rectangle is to whoever sees it.
struct RectangleEdges {
  RectangleEdges(const Vec3& u, const Vec3& v);

  Vec3 u, v;
  Vec3 x, y, normal;  ///< unit
  double width, height, area;
  bool rectangular;  ///< false: a parallelogram
};

/// How a rectangle stands about a point that sees it. T: double or Wide.
template <class T>
struct RectangleView {
  T x0, x1, y0, y1;  ///< the rectangle in its own axes, about the point's foot
  T z;               ///< distance of the plane, >= 0
  T solid_angle;
  T delta0, delta1;  ///< pi minus the angle of the x = x0 and the x = x1 end
  T p0, p1;          ///< sines of the elevations of the y = y0 and y = y1 edges
};

/// A rectangle seen from several points: lane by lane as a SphericalRectangle.
class WideSphericalRectangle {
 public:
  WideSphericalRectangle(const RectangleEdges& edges, const Wide3& corner);

  /// The lanes that are known; the others must be asked for one by one.
  const WideMask& known() const { return known_; }
  const Wide3& corner() const { return corner_; }
  const RectangleView<Wide>& view() const { return view_; }
  const RectangleEdges& edges() const { return edges_; }

 private:
  const RectangleEdges& edges_;
  Wide3 corner_;
  RectangleView<Wide> view_;
  WideMask known_;
};

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
  /// The points corner + s u + t v, s and t in [0,1], relative to the point p that sees them. Keeps
  /// a reference to the edges.
  SphericalRectangle(const RectangleEdges& edges, const Vec3& corner);
  /// What a lane sees; it must be known.
  SphericalRectangle(const WideSphericalRectangle& several, int lane);

  /// Relative error about 1e-14 from 1e-20 to 2 pi; 0 for p in the rectangle's plane.
  double solid_angle() const { return view_.solid_angle; }

  struct Sample {
    Vec3 to_point;  ///< from p to a point of the rectangle; its length is the distance
    double pdf;     ///< per solid angle; the mean over directions weighs by 1/(pdf solid_angle())
  };
  /// Requires solid_angle() > 0.
  Sample sample(const Vec2& xi) const;

  bool by_area() const { return by_area_; }

  const RectangleEdges& edges() const { return *edges_; }
  /// The corner relative to p.
  const Vec3& corner() const { return corner_; }
  const RectangleView<double>& view() const { return view_; }

 private:
  double solid_angle_by_triangles() const;
  Sample sample_area(const Vec2& xi) const;

  const RectangleEdges* edges_;
  Vec3 corner_;
  RectangleView<double> view_;
  bool by_area_;
};

// Each number by itself: what was just stored in pieces is not to be copied as a whole.
inline SphericalRectangle::SphericalRectangle(const WideSphericalRectangle& several, int lane)
    : edges_(&several.edges()), corner_(several.corner().lane(lane)), by_area_(false) {
  const auto at = static_cast<std::size_t>(lane);
  const RectangleView<Wide>& from = several.view();
  view_ = {from.x0[at],          from.x1[at],     from.y0[at],     from.y1[at], from.z[at],
           from.solid_angle[at], from.delta0[at], from.delta1[at], from.p0[at], from.p1[at]};
}

}  // namespace rt
