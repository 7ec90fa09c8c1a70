#include "rt/math/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

#include "rt/math/arctan.h"
#include "rt/math/rounding.h"
#include "rt/math/warp.h"

namespace rt {
namespace {

/// The share of Girard's sum (below) that belongs to the edge at x: atan(x y1 / z r1) -
/// atan(x y0 / z r0), r the distances of the edge's ends. Where y0 and y1 have one sign the two
/// terms would cancel; their difference's tangent is then formed first, with
/// y1 r0 - y0 r1 = (y1^2 - y0^2)(x^2 + z^2) / (y1 r0 + y0 r1). `height` is y1 - y0, exactly.
double edge_angle(double x, double y0, double y1, double height, double z) {
  const double d2 = x * x + z * z;
  const double r0 = std::sqrt(d2 + y0 * y0);
  const double r1 = std::sqrt(d2 + y1 * y1);
  if (!(y0 * y1 > 0.0)) {
    return arctan2(x * y1, z * r1) - arctan2(x * y0, z * r0);
  }
  const double rise = height * (y1 + y0) * (d2 / (y1 * r0 + y0 * r1));
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

}  // namespace

SphericalRectangle::SphericalRectangle(const Vec3& p, const Vec3& corner, const Vec3& u,
                                       const Vec3& v)
    : corner_(corner - p), u_(u), v_(v) {
  const double width = glm::length(u);
  const double height = glm::length(v);
  const Vec3 cross = glm::cross(u, v);
  area_ = glm::length(cross);
  normal_ = cross / area_;
  x_ = u / width;
  y_ = v / height;
  z_ = std::abs(glm::dot(corner_, normal_));
  x0_ = glm::dot(corner_, x_);
  y0_ = glm::dot(corner_, y_);
  x1_ = x0_ + width;
  y1_ = y0_ + height;
  // Perpendicular edges show a dot product of a few roundings.
  const bool rectangular = std::abs(glm::dot(x_, y_)) <= gamma(16);
  if (!rectangular || !(z_ > 0.0)) {
    solid_angle_ = z_ > 0.0 ? solid_angle_by_triangles() : 0.0;
    by_area_ = true;
    return;
  }
  by_area_ = !prepare_map(height);
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
bool SphericalRectangle::prepare_map(double height) {
  delta0_ = -edge_angle(x0_, y0_, y1_, height, z_);
  delta1_ = -edge_angle(x1_, y0_, y1_, height, z_);
  p0_ = y0_ / std::hypot(y0_, z_);
  p1_ = y1_ / std::hypot(y1_, z_);
  const double largest = std::max(std::abs(delta0_), std::abs(delta1_));
  solid_angle_ = delta0_ - delta1_;
  if (!(solid_angle_ > 0x1p-6 * largest)) {
    solid_angle_ = solid_angle_by_triangles();
  }
  constexpr double lost = gamma(16) * 0x1p20;
  const double reach = std::max({std::abs(x0_), std::abs(x1_), std::abs(y0_), std::abs(y1_)});
  return solid_angle_ > lost * largest && z_ * z_ > lost * reach * reach &&
         p1_ - p0_ > lost * std::max(std::abs(p0_), std::abs(p1_));
}

double SphericalRectangle::solid_angle_by_triangles() const {
  const Vec3 opposite = corner_ + u_ + v_;
  return triangle_solid_angle(corner_, corner_ + u_, opposite, area_ * z_) +
         triangle_solid_angle(corner_, opposite, corner_ + v_, area_ * z_);
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
  const double delta = (1.0 - xi.x) * delta0_ + xi.x * delta1_;
  const double sine = std::sin(delta);
  const double half = std::sin(0.5 * delta);
  const double e = (p1_ - p0_) * (p1_ - p0_) + 4.0 * p0_ * p1_ * half * half;
  const double rest = std::sqrt(std::max(0.0, e - sine * sine));
  const double x = std::clamp(rest > 0.0 ? -z_ * sine / rest : x0_, x0_, x1_);
  const double d2 = x * x + z_ * z_;
  const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_);
  const double h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const double h = h0 + xi.y * (h1 - h0);
  const double y = std::clamp(h * std::sqrt(d2 / ((1.0 - h) * (1.0 + h))), y0_, y1_);
  return {corner_ + (x - x0_) * x_ + (y - y0_) * y_, 1.0 / solid_angle_};
}

SphericalRectangle::AtDistance1 SphericalRectangle::at_distance_1() const {
  const Vec3 ahead = std::copysign(1.0, glm::dot(corner_, normal_)) * normal_;
  return {x_, y_, ahead, x0_ / z_, x1_ / z_, y0_ / z_, y1_ / z_};
}

// dA = distance^2 / cos dOmega, and cos = z / distance.
SphericalRectangle::Sample SphericalRectangle::sample_area(const Vec2& xi) const {
  const Vec3 to_point = corner_ + xi.x * u_ + xi.y * v_;
  const double d2 = glm::dot(to_point, to_point);
  return {to_point, d2 * std::sqrt(d2) / (area_ * z_)};
}

}  // namespace rt
