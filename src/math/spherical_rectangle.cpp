#include "rt/math/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

#include "rt/math/arctan.h"
#include "rt/math/rounding.h"
#include "rt/math/warp.h"

namespace rt {
namespace {

/// The share of Girard's sum (below) that belongs to the edge at x: atan(x y1 / z r1) -
/// atan(x y0 / z r0), r the distances of the edge's ends, by that difference's tangent. Where y0
/// and y1 have one sign it would cancel; then y1 r0 - y0 r1 = (y1^2 - y0^2)(x^2 + z^2) / (y1 r0 +
/// y0 r1). `height` is y1 - y0, exactly.
template <class T>
T edge_angle(const T& x, const T& y0, const T& y1, double height, const T& z) {
  using std::sqrt;
  const T d2 = x * x + z * z;
  const T r0 = sqrt(d2 + y0 * y0);
  const T r1 = sqrt(d2 + y1 * y1);
  const T a = y1 * r0;
  const T b = y0 * r1;
  const T rise = select(y0 * y1 > 0.0, height * (y1 + y0) * (d2 / (a + b)), a - b);
  return arctan2(x * z * rise, z * r0 * (z * r1) + x * y0 * (x * y1));
}

/// A triangle's solid angle, after van Oosterom and Strackee, "The solid angle of a plane
/// triangle", IEEE Trans. Biomed. Eng. 30(2), 1983. `triple` is the volume a.(b x c), twice the
/// area times the distance of the plane: given as that product it has no cancellation.
double triangle_solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, double triple) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  return 2.0 * arctan2(triple, la * lb * lc + glm::dot(a, b) * lc + glm::dot(a, c) * lb +
                                   glm::dot(b, c) * la);
}

// The part of the rectangle up to x is a spherical quadrilateral with angles (Girard)
//   g(y0,x) + g(y1,x) + g(y1,x0) + g(y0,x0) - 2 pi = its solid angle.
// At a corner the planes of its two edges have normals (0, z, -y) and (-z, 0, x) up to sign, so
// with r the corner's distance, g = pi/2 -+ atan(x y / z r); no arc cosine is needed. Put
//   delta(x) = pi - g(y0,x) - g(y1,x) = atan(x y0 / z r0) - atan(x y1 / z r1) = -edge_angle(x).
// The solid angle up to x is delta(x0) - delta(x), and a uniform share u of it ends where
// delta = (1-u) delta(x0) + u delta(x1).
//
// What still cancels is that difference, where the rectangle lies far to the side in x; the
// difference of p0 and p1 (below), where it does in y; and 1 - c^2, which is z^2 / (x^2 + z^2).
// Each must keep enough digits to place points to 2^-20 of the rectangle; the solid angle as such
// comes from triangles where the rectangle is narrow beside its offset, which is where they are
// accurate.
template <class T, class V>
RectangleView<T> view_of(const RectangleEdges& edges, const V& corner) {
  using std::abs;
  using std::max;
  using std::sqrt;
  RectangleView<T> v;
  v.z = abs(dot(corner, V(edges.normal)));
  v.x0 = dot(corner, V(edges.x));
  v.y0 = dot(corner, V(edges.y));
  v.x1 = v.x0 + edges.width;
  v.y1 = v.y0 + edges.height;
  v.delta0 = -edge_angle(v.x0, v.y0, v.y1, edges.height, v.z);
  v.delta1 = -edge_angle(v.x1, v.y0, v.y1, edges.height, v.z);
  v.p0 = v.y0 / sqrt(v.y0 * v.y0 + v.z * v.z);
  v.p1 = v.y1 / sqrt(v.y1 * v.y1 + v.z * v.z);
  v.solid_angle = v.delta0 - v.delta1;
  return v;
}

/// Where that solid angle has its digits.
template <class T>
auto told(const RectangleView<T>& v) {
  using std::abs;
  using std::max;
  return v.solid_angle > 0x1p-6 * max(abs(v.delta0), abs(v.delta1));
}

/// Where the map has.
template <class T>
auto mapped(const RectangleView<T>& v) {
  using std::abs;
  using std::max;
  constexpr double lost = gamma(16) * 0x1p20;
  const T reach = max(max(abs(v.x0), abs(v.x1)), max(abs(v.y0), abs(v.y1)));
  return v.solid_angle > lost * max(abs(v.delta0), abs(v.delta1)) &&
         v.z * v.z > lost * reach * reach && v.p1 - v.p0 > lost * max(abs(v.p0), abs(v.p1));
}

}  // namespace

RectangleEdges::RectangleEdges(const Vec3& edge_u, const Vec3& edge_v)
    : u(edge_u), v(edge_v), width(glm::length(u)), height(glm::length(v)) {
  const Vec3 cross = glm::cross(u, v);
  area = glm::length(cross);
  normal = cross / area;
  x = u / width;
  y = v / height;
  // Perpendicular edges show a dot product of a few roundings.
  rectangular = std::abs(glm::dot(x, y)) <= gamma(16);
}

SphericalRectangle::SphericalRectangle(const RectangleEdges& edges, const Vec3& corner)
    : edges_(&edges), corner_(corner), view_(view_of<double>(edges, corner)) {
  const bool has_map = edges.rectangular && view_.z > 0.0;
  if (!(view_.z > 0.0)) {
    view_.solid_angle = 0.0;
  } else if (!has_map || !told(view_)) {
    view_.solid_angle = solid_angle_by_triangles();
  }
  by_area_ = !has_map || !mapped(view_);
}

WideSphericalRectangle::WideSphericalRectangle(const RectangleEdges& edges, const Wide3& corner)
    : edges_(edges), corner_(corner), view_(view_of<Wide>(edges, corner)) {
  known_ = view_.z > 0.0 && told(view_) && mapped(view_) && WideMask(edges.rectangular);
}

double SphericalRectangle::solid_angle_by_triangles() const {
  const Vec3 opposite = corner_ + edges_->u + edges_->v;
  const double volume = edges_->area * view_.z;
  return triangle_solid_angle(corner_, corner_ + edges_->u, opposite, volume) +
         triangle_solid_angle(corner_, opposite, corner_ + edges_->v, volume);
}

// delta(x) is to be inverted. With c = x / sqrt(x^2 + z^2), cos g(y0,x) = p0 c and cos g(y1,x) =
// -p1 c. Eliminating one angle from g + g' = pi - delta gives
//   c = -sin delta / sqrt(E),  E = p0^2 + p1^2 - 2 p0 p1 cos delta
//                                = (p1 - p0)^2 + 4 p0 p1 sin^2(delta/2),
// and x = z c / sqrt(1 - c^2) = -z sin delta / sqrt(E - sin^2 delta). Along the arc at x, area is
// proportional to the sine of elevation (Archimedes), so that sine is drawn uniformly.
SphericalRectangle::Sample SphericalRectangle::sample(const Vec2& xi) const {
  if (by_area_) {
    return sample_area(xi);
  }
  const auto& [x0, x1, y0, y1, z, solid_angle, delta0, delta1, p0, p1] = view_;
  const double delta = (1.0 - xi.x) * delta0 + xi.x * delta1;
  const double half = std::sin(0.5 * delta);
  const double sine = 2.0 * half * std::cos(0.5 * delta);
  const double e = (p1 - p0) * (p1 - p0) + 4.0 * p0 * p1 * half * half;
  const double rest = std::sqrt(std::max(0.0, e - sine * sine));
  const double x = std::clamp(rest > 0.0 ? -z * sine / rest : x0, x0, x1);
  const double d2 = x * x + z * z;
  const double h0 = y0 / std::sqrt(d2 + y0 * y0);
  const double h1 = y1 / std::sqrt(d2 + y1 * y1);
  const double h = h0 + xi.y * (h1 - h0);
  const double y = std::clamp(h * std::sqrt(d2 / ((1.0 - h) * (1.0 + h))), y0, y1);
  return {corner_ + (x - x0) * edges_->x + (y - y0) * edges_->y, 1.0 / solid_angle};
}

// dA = distance^2 / cos dOmega, and cos = z / distance.
SphericalRectangle::Sample SphericalRectangle::sample_area(const Vec2& xi) const {
  const Vec3 to_point = corner_ + xi.x * edges_->u + xi.y * edges_->v;
  const double d2 = glm::dot(to_point, to_point);
  return {to_point, d2 * std::sqrt(d2) / (edges_->area * view_.z)};
}

}  // namespace rt
