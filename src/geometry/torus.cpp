#include "rt/geometry/torus.h"

#include "longitude.h"
#include "rt/math/rounding.h"
#include "torus_form.h"

namespace rt {

SurfacePoint surface_point(const Torus& shape, const Ray& ray, const ShapeHit& hit) {
  const Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  const Meridian m = meridian(p);
  const double sheet = sheet_at(shape, m.radius, p.y);
  const double w = m.radius - sheet * shape.major_radius;
  const double length = std::sqrt(w * w + p.y * p.y);
  // Cosine and sine of the angle around the tube; its circle's centre is sheet * R along the
  // meridian.
  const double cosine = length > 0 ? w / length : 1;
  const double sine = length > 0 ? p.y / length : 0;
  const double radius = sheet * shape.major_radius + shape.minor_radius * cosine;
  const Vec3 normal = sheet * Vec3(cosine * m.cosine, sine, cosine * m.sine);
  return {Vec3(radius * m.cosine, shape.minor_radius * sine, radius * m.sine), normal, normal};
}

/// On the lemon of a spindle torus the tube's circle has its centre across the axis.
SurfaceCoordinates surface_coordinates(const Torus& shape, const SurfacePoint& point,
                                       std::uint32_t) {
  const Vec3& p = point.position;
  const Meridian m = meridian(p);
  const double sheet = sheet_at(shape, m.radius, p.y);
  const double cosine = sheet * m.cosine;
  const double sine = sheet * m.sine;
  const double w = sheet * m.radius - shape.major_radius;
  return {{turns(sheet * p.z, sheet * p.x), turns(p.y, w)},
          two_pi * Vec3(-p.z, 0, p.x),
          two_pi * Vec3(-p.y * cosine, w, -p.y * sine)};
}

/// The tube is a sphere of radius r that rides on the ring: normal = (p - centre) / r.
Vec3 normal_change(const Torus& shape, const SurfacePoint& point, std::uint32_t, const Vec3& step) {
  const Vec3& p = point.position;
  const Meridian m = meridian(p);
  const double R = sheet_at(shape, m.radius, p.y) * shape.major_radius;
  const Vec3 along(-m.sine, 0, m.cosine);
  const double turn = m.radius > 0 ? glm::dot(step, along) / m.radius : 0.0;
  const Vec3 from_ring = p - R * Vec3(m.cosine, 0, m.sine);
  const Vec3 change = (step - R * turn * along) / shape.minor_radius;
  return glm::dot(from_ring, point.normal) < 0 ? -change : change;
}

Bounds bounds(const Torus& shape) {
  const double reach = size_of(shape) * (1 + gamma(1));
  return {Vec3(-reach, -shape.minor_radius, -reach), Vec3(reach, shape.minor_radius, reach)};
}

}  // namespace rt
