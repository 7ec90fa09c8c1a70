#include "rt/render/seen_light.h"

#include <algorithm>
#include <array>

#include "rt/math/arctan.h"
#include "rt/math/spherical_rectangle.h"
#include "rt/math/warp.h"

namespace rt {
namespace {

/// A disc of this radius in the plane at distance 1 still has its points to 2^-20 of it: at_angle()
/// loses the square of the radius.
constexpr double widest = 0x1p16;

/// The angle that an edge from a to b subtends, at a distance from its line.
template <class T>
T subtended(const T& a, const T& b, const T& distance) {
  return arctan2(T(distance * (b - a)), T(distance * distance + a * b));
}

/// The mean is half the sum of the edges' angles times the normals of their planes (Lambert), over
/// the solid angle.
template <class T, class V>
RectangleAhead<T, V> ahead_of(const RectangleEdges& edges, const V& corner,
                              const RectangleView<T>& v) {
  using std::copysign;
  using std::sqrt;
  RectangleAhead<T, V> r;
  r.z = copysign(T(1.0), dot(corner, V(edges.normal))) * V(edges.normal);
  r.x0 = v.x0 / v.z;
  r.x1 = v.x1 / v.z;
  r.y0 = v.y0 / v.z;
  r.y1 = v.y1 / v.z;
  const auto edge = [](const T& at, const T& a, const T& b) -> T {
    const T distance = sqrt(1.0 + at * at);
    return subtended(a, b, distance) / distance;
  };
  const T left = edge(r.x0, r.y0, r.y1);
  const T right = edge(r.x1, r.y0, r.y1);
  const T top = edge(r.y0, r.x0, r.x1);
  const T bottom = edge(r.y1, r.x0, r.x1);
  const T ahead = r.x1 * right - r.x0 * left + r.y1 * bottom - r.y0 * top;
  r.mean = ((left - right) * V(edges.x) + (top - bottom) * V(edges.y) + ahead * r.z) *
           (0.5 / v.solid_angle);
  return r;
}

}  // namespace

void LightLine::clip(const Vec3& n) {
  const double at_start = glm::dot(n, start);
  const double rise = glm::dot(n, step);
  if (rise > 0.0) {
    first = std::max(first, -at_start / rise);
  } else if (rise < 0.0) {
    last = std::min(last, -at_start / rise);
  } else if (!(at_start > 0.0)) {
    last = first;
  }
}

// Of n.(start + s step) / sqrt(square + s^2), times the angle's density square / (square +
// s^2)^(3/2).
double LightLine::cosine_to(double s, const Vec3& n) const {
  const double root = std::sqrt(square_);
  const double inverse = 1.0 / (square_ + s * s);
  return 0.5 * (glm::dot(n, start) * (s * inverse + arctan2(s, root) / root) +
                glm::dot(n, step) * (s * s * inverse));
}

SeenLight::SeenLight(const SphericalRectangle& rectangle, const RectangleAhead<double, Vec3>& r)
    : rectangle_(rectangle),
      x_(rectangle.edges().x),
      y_(rectangle.edges().y),
      z_(r.z),
      lo_(r.x0, r.y0),
      hi_(r.x1, r.y1),
      middle_(0.5 * (lo_ + hi_)),
      mean_(r.mean),
      depth_(rectangle.view().z) {}

SeenLight::SeenLight(const WideSphericalRectangle& rectangle, const RectangleAhead<Wide, Wide3>& r,
                     int lane)
    : rectangle_(std::in_place, rectangle, lane),
      x_(rectangle.edges().x),
      y_(rectangle.edges().y),
      z_(r.z.lane(lane)),
      mean_(r.mean.lane(lane)) {
  const auto at = static_cast<std::size_t>(lane);
  lo_ = {r.x0[at], r.y0[at]};
  hi_ = {r.x1[at], r.y1[at]};
  middle_ = 0.5 * (lo_ + hi_);
  depth_ = rectangle.view().z[at];
}

std::optional<SeenLight> SeenLight::from(const Vec3& p, const PlannedLight& light) {
  if (light.edges) {
    const SphericalRectangle rectangle(*light.edges, light.first_corner() - p);
    if (rectangle.by_area() || !(rectangle.solid_angle() > 0.0)) {
      return std::nullopt;
    }
    return SeenLight(rectangle,
                     ahead_of<double>(*light.edges, rectangle.corner(), rectangle.view()));
  }
  SeenLight seen;
  const Vec3 way = light.position - p;
  const double d = glm::length(way);
  const double free = (d - light.radius) * (d + light.radius);
  if (!(light.radius > 0.0 && free * (widest * widest) > light.radius * light.radius)) {
    return std::nullopt;
  }
  const Frame frame = frame_about(way / d);
  seen.x_ = frame.x;
  seen.y_ = frame.y;
  seen.z_ = frame.z;
  seen.radius_ = light.radius / std::sqrt(free);
  seen.free_ = free;
  seen.far_ = d;
  seen.mean_ = frame.z * (0.5 * (1.0 + std::sqrt(free) / d));
  seen.depth_ = d - light.radius;  // of its nearest point: what stands inside hides nothing
  return seen;
}

WideSeenLight::WideSeenLight(const Wide3& p, const PlannedLight& light) : p_(p), light_(light) {
  if (light.edges) {
    rectangle_.emplace(*light.edges, Wide3(light.first_corner()) - p);
    ahead_ = ahead_of<Wide>(*light.edges, rectangle_->corner(), rectangle_->view());
  }
}

std::optional<SeenLight> WideSeenLight::lane(int i) const {
  if (!rectangle_ || !rectangle_->known()[static_cast<std::size_t>(i)]) {
    return SeenLight::from(p_.lane(i), light_);
  }
  return std::optional<SeenLight>(std::in_place, *rectangle_, ahead_, i);
}

bool SeenLight::above(const Vec3& n) const {
  const Vec3 local{glm::dot(n, x_), glm::dot(n, y_), glm::dot(n, z_)};
  if (!rectangle_) {
    return local.z >= radius_ * std::sqrt(local.x * local.x + local.y * local.y);
  }
  // The least of what is linear stands at a corner.
  return std::min(local.x * lo_.x, local.x * hi_.x) + std::min(local.y * lo_.y, local.y * hi_.y) +
             local.z >=
         0.0;
}

double SeenLight::mean_cosine(const Vec3& n) const {
  if (above(n)) {
    return glm::dot(n, mean_);
  }
  if (above(-n)) {
    return 0.0;
  }
  const Vec3 local{glm::dot(n, x_), glm::dot(n, y_), glm::dot(n, z_)};
  return rectangle_ ? rectangle_cosine(local) : disc_cosine(local);
}

// Lambert's sum over the edges of what stands above the horizon.
double SeenLight::rectangle_cosine(const Vec3& local) const {
  const std::array<Vec3, 4> corners{Vec3(lo_, 1.0), Vec3(hi_.x, lo_.y, 1.0), Vec3(hi_, 1.0),
                                    Vec3(lo_.x, hi_.y, 1.0)};
  std::array<Vec3, 5> kept;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % 4];
    const double height = glm::dot(local, a);
    const double next = glm::dot(local, b);
    if (height >= 0.0) {
      kept[count++] = a;
    }
    if ((height >= 0.0) != (next >= 0.0)) {
      kept[count++] = (a * next - b * height) / (next - height);
    }
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& a = kept[i];
    const Vec3& b = kept[(i + 1) % count];
    const Vec3 normal = glm::cross(a, b);
    const double length = glm::length(normal);
    if (length > 0.0) {
      sum += arctan2(length, glm::dot(a, b)) * glm::dot(normal, local) / length;
    }
  }
  return 0.5 * sum / rectangle_->solid_angle();
}

// A cap that the horizon cuts: Snyder, "Area light sources for real-time graphics", MSR-TR-96-11,
// 1996, here per solid angle. r is the tangent of the cap's half-angle.
double SeenLight::disc_cosine(const Vec3& local) const {
  const double sine = std::sqrt(local.x * local.x + local.y * local.y);
  const double x = 1.0 / radius_;
  const double y = std::clamp(-x * local.z / sine, -1.0, 1.0);
  const double z = sine * std::sqrt((1.0 - y) * (1.0 + y));
  const double square = radius_ * radius_ / (1.0 + radius_ * radius_);
  const double whole = 2.0 * pi * square / (1.0 + 1.0 / std::sqrt(1.0 + radius_ * radius_));
  return ((local.z * std::acos(y) - x * z) * square + arctan2(z * radius_, 1.0)) / whole;
}

// The light lies within a cone about its middle, of a half-angle `reach` at most: distances in the
// plane bound those on the sphere. cos(angle - reach), reach's cosine and sine by the first terms
// of their series, on the safe side.
double SeenLight::largest_cosine(const Vec3& n) const {
  const double reach = rectangle_ ? 0.5 * glm::length(hi_ - lo_) : radius_;
  const double to_middle = std::sqrt(1.0 + glm::dot(middle_, middle_));
  const double cosine = glm::dot(n, z_ + middle_.x * x_ + middle_.y * y_) / to_middle;
  const double sine = std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine)));
  const double square = reach * reach;
  const double least = 1.0 - 0.5 * square;
  if (cosine >= least) {
    return 1.0;
  }
  const double most = least + square * square / 24.0;
  return cosine * (cosine > 0.0 ? most : least) +
         sine * reach * (1.0 - square * (1.0 / 6.0 - square / 120.0));
}

Vec3 SeenLight::sample(const Vec2& u) const {
  if (rectangle_) {
    return glm::normalize(rectangle_->sample(u).to_point);
  }
  const double sin2 = radius_ * radius_ * (free_ / (far_ * far_));
  return Frame{x_, y_, z_}.to_world(to_cone(u, Cone::from_sin2(sin2)));
}

double SeenLight::distance(const Vec3& direction) const {
  const double ahead = glm::dot(direction, z_);
  if (rectangle_) {
    return depth_ / ahead;
  }
  const double middle = far_ * ahead;
  return free_ / (middle + std::sqrt(std::max(0.0, middle * middle - free_)));
}

Vec2 SeenLight::point_of(const Vec3& direction) const {
  return Vec2(glm::dot(direction, x_), glm::dot(direction, y_)) / glm::dot(direction, z_);
}

LightLine SeenLight::line(const Vec2& through) const {
  const Vec3 start = z_ + through.y * y_;
  if (rectangle_) {
    return {start, x_, lo_.x, hi_.x};
  }
  const double half = std::sqrt(std::max(0.0, (radius_ - through.y) * (radius_ + through.y)));
  return {start, x_, -half, half};
}

}  // namespace rt
