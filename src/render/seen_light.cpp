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
double subtended(double a, double b, double distance) {
  return arctan2(distance * (b - a), distance * distance + a * b);
}

/// The mean of unit directions over a rectangle at distance 1: half the sum of its edges' angles
/// times the normals of their planes (Lambert), over the solid angle.
Vec3 mean_over(const SphericalRectangle::AtDistance1& r, double solid_angle) {
  const auto edge = [](double at, double a, double b) {
    const double distance = std::sqrt(1.0 + at * at);
    return subtended(a, b, distance) / distance;
  };
  const double left = edge(r.x0, r.y0, r.y1);
  const double right = edge(r.x1, r.y0, r.y1);
  const double top = edge(r.y0, r.x0, r.x1);
  const double bottom = edge(r.y1, r.x0, r.x1);
  const double ahead = r.x1 * right - r.x0 * left + r.y1 * bottom - r.y0 * top;
  return ((left - right) * r.x + (top - bottom) * r.y + ahead * r.z) * (0.5 / solid_angle);
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

std::optional<SeenLight> SeenLight::from(const Vec3& p, const Light& light) {
  SeenLight seen;
  if (light.rectangle) {
    const auto& [u, v] = *light.rectangle;
    const SphericalRectangle& rectangle =
        seen.rectangle_.emplace(p, light.position - 0.5 * (u + v), u, v);
    if (rectangle.by_area() || !(rectangle.solid_angle() > 0.0)) {
      return std::nullopt;
    }
    const auto r = rectangle.at_distance_1();
    seen.x_ = r.x;
    seen.y_ = r.y;
    seen.z_ = r.z;
    seen.lo_ = {r.x0, r.y0};
    seen.hi_ = {r.x1, r.y1};
    seen.middle_ = 0.5 * (seen.lo_ + seen.hi_);
    seen.mean_ = mean_over(r, rectangle.solid_angle());
    seen.depth_ = rectangle.distance();
    return seen;
  }
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
  seen.depth_ = free / d;  // of the circle where the cone touches the sphere
  return seen;
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

// The light lies within a cone about its middle.
double SeenLight::largest_cosine(const Vec3& n) const {
  const Vec2 half = rectangle_ ? 0.5 * (hi_ - lo_) : Vec2(radius_);
  const Vec3 axis = glm::normalize(z_ + middle_.x * x_ + middle_.y * y_);
  // Distances in the plane bound those on the sphere.
  const double reach = rectangle_ ? glm::length(half) : arctan2(radius_, 1.0);
  const double angle = std::acos(std::clamp(glm::dot(n, axis), -1.0, 1.0)) - reach;
  return angle > 0.0 ? std::cos(angle) : 1.0;
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
