#include "rt/geometry/mesh.h"

#include "convex.h"
#include "rt/geometry/exact.h"
#include "rt/geometry/wide_shapes.h"
#include "rt/math/rounding.h"

namespace rt {
namespace {

/// A vertex as the ray sees it: its offset from the ray in two coordinates across (scaled by the
/// direction's main component), and its distance from the origin along the main axis.
struct Seen {
  double x, y;
  DoublePair depth;
};

/// The ray's view (Woop, Benthin & Wald 2013, "Watertight ray/triangle intersection"). In place of
/// their shear by quotients the coordinates are multiplied out from exact differences, so each has
/// a relative error of a few u however far away the origin is. A vertex' image depends on ray and
/// vertex alone: triangles that share an edge see the same edge.
class View {
 public:
  explicit View(const Ray& ray) : ray_(ray) {
    const Vec3 a = glm::abs(ray.direction);
    z_ = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
  }

  Seen operator()(const Vec3& vertex) const {
    const DoublePair depth = exact_difference(vertex[z_], ray_.origin[z_]);
    return {across(vertex, x_, depth), across(vertex, y_, depth), depth};
  }
  double main_part(const Vec3& v) const { return v[z_]; }

 private:
  double across(const Vec3& vertex, int i, const DoublePair& depth) const {
    const DoublePair side = exact_difference(vertex[i], ray_.origin[i]);
    const double dz = ray_.direction[z_];
    const double di = ray_.direction[i];
    return difference_of_products(side.high, dz, depth.high, di) + (side.low * dz - depth.low * di);
  }

  const Ray& ray_;
  int x_, y_, z_;
};

/// Whether the line plainly passes the triangle by, as most do that come near one. The signs are those
/// of the volumes d . (c x b), d . (a x c), d . (b x a), corners seen from the origin: each is a sum
/// of six products that have been rounded at most seven times, and with |d|_1 the sum of d's parts
/// their sizes add up to at most |d|_1 |b| |c|. What underflow may add is far less than what the
/// bound's last term says.
template <class Real, class V>
auto passes_by(const V& origin, const V& d, const Vec3& a, const Vec3& b, const Vec3& c) {
  using std::abs, std::max, std::min;
  const V p = V(a) - origin;
  const V q = V(b) - origin;
  const V r = V(c) - origin;
  const Real u = dot(d, cross(r, q));
  const Real v = dot(d, cross(p, r));
  const Real w = dot(d, cross(q, p));
  const Real size = max(max(dot(p, p), dot(q, q)), dot(r, r));
  const Real sum = abs(d.x) + abs(d.y) + abs(d.z);
  const Real error = gamma(16) * sum * size + (1.0 + sum) * std::numeric_limits<double>::min();
  return max(max(u, v), w) > error && min(min(u, v), w) < -error;
}

/// Whether the origin is so close to the triangle's plane that arithmetic cannot tell the two
/// apart. normal . (o - a) takes a rounded difference, a cross product good to 1.5 ulp, three
/// products and two sums: its error is below gamma(8) |e1| |e2| |o - a|.
bool coincident(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& o, double error) {
  const Vec3 normal = exact_cross(b - a, c - a);
  const double rounding = gamma(8) * glm::length(b - a) * glm::length(c - a) * glm::length(o - a);
  return std::abs(glm::dot(normal, o - a)) <= error * glm::length(normal) + rounding;
}

/// Whether a ray that left triangle `left` to one side meets another from the opposite side before
/// it has got clear of the error of its origin: it is then under the left triangle's plane by that
/// error alone, and comes out beside an edge where it was out before.
bool comes_out_again(const MeshData& mesh, const Corners& other, const Ray& ray, double t,
                     const RayStart& start) {
  const Corners& left = mesh.triangles[start.feature];
  const auto normal_of = [&](const Corners& c) {
    const Vec3& a = mesh.positions[c[0]];
    return exact_cross(mesh.positions[c[1]] - a, mesh.positions[c[2]] - a);
  };
  const Vec3 normal = normal_of(left);
  const double side = start.leaving == Leaving::outward ? 1 : -1;
  if (!(side * glm::dot(normal_of(other), ray.direction) > 0)) {
    return false;
  }
  const Vec3 from_left = ray.at(t) - mesh.positions[left[0]];
  return side * glm::dot(normal, from_left) <= start.position_error * glm::length(normal);
}

/// Weights of the corners at a point of the triangle's plane, each in [0,1].
struct Weights {
  double a, b, c;
};

Weights weights_at(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 normal = exact_cross(b - a, c - a);
  const double wa = std::max(0.0, glm::dot(exact_cross(b - p, c - p), normal));
  const double wb = std::max(0.0, glm::dot(exact_cross(c - p, a - p), normal));
  const double wc = std::max(0.0, glm::dot(exact_cross(a - p, b - p), normal));
  const double sum = wa + wb + wc;
  if (sum > 0) {
    return {wa / sum, wb / sum, wc / sum};
  }
  return {1, 0, 0};  // a triangle without an area
}

/// The vertex normals' mean, on the geometric normal's side of the surface.
Vec3 shading_normal(const MeshData& mesh, std::uint32_t triangle, const Weights& w,
                    const Vec3& geometric) {
  const Corners& n = mesh.triangle_normals[triangle];
  const Vec3 mean = w.a * mesh.normals[n[0]] + w.b * mesh.normals[n[1]] + w.c * mesh.normals[n[2]];
  const double length = glm::length(mean);
  if (!(length > 0)) {
    return geometric;
  }
  return glm::dot(mean, geometric) < 0 ? -mean / length : mean / length;
}

}  // namespace

OptionalHit intersect_triangle(const MeshData& mesh, std::uint32_t triangle, const Ray& ray,
                               double t_max, const RayStart& start) {
  if (start.leaving != Leaving::nothing && start.feature == triangle) {
    return {};  // a plane that was left is never met again
  }
  const Corners& corners = mesh.triangles[triangle];
  const Vec3& a = mesh.positions[corners[0]];
  const Vec3& b = mesh.positions[corners[1]];
  const Vec3& c = mesh.positions[corners[2]];
  if (passes_by<double>(ray.origin, ray.direction, a, b, c)) {
    return {};
  }
  const View view(ray);
  const Seen sa = view(a);
  const Seen sb = view(b);
  const Seen sc = view(c);
  // Signs of these are exact for the images, and opposite for the two triangles of an edge; a ray
  // exactly through the edge (zero) hits both.
  const double u = signed_difference(sc.x, sb.y, sc.y, sb.x);
  const double v = signed_difference(sa.x, sc.y, sa.y, sc.x);
  const double w = signed_difference(sb.x, sa.y, sb.y, sa.x);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) {
    return {};
  }
  const double sum = u + v + w;
  if (!(sum != 0)) {
    return {};  // edge-on
  }
  // The corners' mean depth with positive weights, as the first corner's and a correction of the
  // triangle's own size: from afar it is rounded once.
  const double beyond = (v * view.main_part(b - a) + w * view.main_part(c - a)) / sum;
  const double depth = sa.depth.high + (sa.depth.low + beyond);
  const OptionalHit hit = hit_in_range(depth / view.main_part(ray.direction), triangle, t_max);
  if (hit && start.position_error > 0 && coincident(a, b, c, ray.origin, start.position_error)) {
    return {};
  }
  if (hit && start.leaving != Leaving::nothing && start.position_error > 0 &&
      comes_out_again(mesh, corners, ray, hit->t, start)) {
    return {};
  }
  return hit;
}

WideMask passes_by(const MeshData& mesh, std::uint32_t triangle, const WideRay& ray) {
  const Corners& corners = mesh.triangles[triangle];
  return passes_by<Wide>(ray.origin, ray.direction, mesh.positions[corners[0]],
                         mesh.positions[corners[1]], mesh.positions[corners[2]]);
}

Bounds triangle_bounds(const MeshData& mesh, std::uint32_t triangle) {
  Bounds out;
  for (const std::uint32_t corner : mesh.triangles[triangle]) {
    out.extend(mesh.positions[corner]);
  }
  return out;
}

OptionalHit intersect(const Mesh& shape, const Ray& ray, double t_max, const RayStart& start) {
  OptionalHit nearest;
  const auto count = static_cast<std::uint32_t>(shape.data->triangles.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const OptionalHit hit =
        intersect_triangle(*shape.data, i, ray, nearest ? nearest->t : t_max, start);
    if (hit && (!nearest || hit->t < nearest->t)) {
      nearest = hit;
    }
  }
  return nearest;
}

SurfacePoint surface_point(const Mesh& shape, const Ray& ray, const ShapeHit& hit) {
  const MeshData& mesh = *shape.data;
  const Corners& corners = mesh.triangles[hit.feature];
  const Vec3& a = mesh.positions[corners[0]];
  const Vec3& b = mesh.positions[corners[1]];
  const Vec3& c = mesh.positions[corners[2]];
  Vec3 p = fused_at(ray.origin, ray.direction, hit.t);
  const Vec3 cross = exact_cross(b - a, c - a);
  const double area = glm::length(cross);
  if (!(area > 0)) {
    const Vec3 back = -glm::normalize(ray.direction);
    return {p, back, back};
  }
  const Vec3 normal = cross / area;
  p -= glm::dot(p - a, normal) * normal;
  if (mesh.normals.empty() || mesh.triangle_normals.empty()) {
    return {p, normal, normal};
  }
  return {p, normal, shading_normal(mesh, hit.feature, weights_at(a, b, c, p), normal)};
}

/// The file's texture coordinates, or the weights of the second and third corner where it has none.
SurfaceCoordinates surface_coordinates(const Mesh& shape, const SurfacePoint& point,
                                       std::uint32_t feature) {
  const MeshData& mesh = *shape.data;
  const Corners& corners = mesh.triangles[feature];
  const Vec3& a = mesh.positions[corners[0]];
  const Vec3 ab = mesh.positions[corners[1]] - a;
  const Vec3 ac = mesh.positions[corners[2]] - a;
  const Weights w = weights_at(a, a + ab, a + ac, point.position);
  if (mesh.uvs.empty() || mesh.triangle_uvs.empty()) {
    return {{w.b, w.c}, ab, ac};
  }
  const Corners& t = mesh.triangle_uvs[feature];
  const Vec2 ta = mesh.uvs[t[0]];
  const Vec2 tb = mesh.uvs[t[1]] - ta;
  const Vec2 tc = mesh.uvs[t[2]] - ta;
  const Vec2 uv = ta + w.b * tb + w.c * tc;
  const double determinant = difference_of_products(tb.x, tc.y, tb.y, tc.x);
  if (!(determinant != 0)) {
    return {uv, ab, ac};  // the map has no inverse: any finite derivatives will do
  }
  return {uv, (tc.y * ab - tb.y * ac) / determinant, (tb.x * ac - tc.x * ab) / determinant};
}

Vec3 normal_change(const Mesh& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step) {
  const MeshData& mesh = *shape.data;
  if (mesh.normals.empty() || mesh.triangle_normals.empty()) {
    return Vec3(0.0);
  }
  const Corners& corners = mesh.triangles[feature];
  const Vec3& a = mesh.positions[corners[0]];
  const Vec3 ab = mesh.positions[corners[1]] - a;
  const Vec3 ac = mesh.positions[corners[2]] - a;
  const Vec3 cross = exact_cross(ab, ac);
  const double square = glm::dot(cross, cross);
  if (!(square > 0)) {
    return Vec3(0.0);
  }
  // The weights' change, b along ab and c along ac, and that of the weighted mean of normals.
  const double b = glm::dot(glm::cross(step, ac), cross) / square;
  const double c = glm::dot(glm::cross(ab, step), cross) / square;
  const Corners& n = mesh.triangle_normals[feature];
  const Vec3& na = mesh.normals[n[0]];
  const Weights w = weights_at(a, a + ab, a + ac, point.position);
  const Vec3 mean = w.a * na + w.b * mesh.normals[n[1]] + w.c * mesh.normals[n[2]];
  const double length = glm::length(mean);
  if (!(length > 0)) {
    return Vec3(0.0);
  }
  const Vec3 change = (b * (mesh.normals[n[1]] - na) + c * (mesh.normals[n[2]] - na)) / length;
  const Vec3 unit = mean / length;
  const Vec3 across = change - glm::dot(change, unit) * unit;
  return glm::dot(mean, point.normal) < 0 ? -across : across;
}

Bounds bounds(const Mesh& shape) {
  Bounds out;
  const auto count = static_cast<std::uint32_t>(shape.data->triangles.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    out.extend(triangle_bounds(*shape.data, i));
  }
  return out;
}

}  // namespace rt
