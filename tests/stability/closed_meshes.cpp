#include "stability/closed_meshes.h"

#include <cmath>
#include <numbers>

namespace rt::stability {
namespace {

Mesh mesh_of(MeshData data) { return Mesh{std::make_shared<const MeshData>(std::move(data))}; }

/// Two triangles for the corners of a quadrilateral, counter-clockwise from outside.
void add_quad(MeshData& data, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  data.triangles.push_back({a, b, c});
  data.triangles.push_back({a, c, d});
}

void add_cut(MeshData& data, const Vec3& a, const Vec3& b, const Vec3& c, int cuts) {
  if (cuts > 0) {
    const Vec3 ab = glm::normalize(a + b);
    const Vec3 bc = glm::normalize(b + c);
    const Vec3 ca = glm::normalize(c + a);
    add_cut(data, a, ab, ca, cuts - 1);
    add_cut(data, ab, b, bc, cuts - 1);
    add_cut(data, ca, bc, c, cuts - 1);
    add_cut(data, ab, bc, ca, cuts - 1);
    return;
  }
  const auto first = static_cast<std::uint32_t>(data.positions.size());
  data.positions.insert(data.positions.end(), {a, b, c});
  data.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace

Mesh box_mesh() {
  MeshData data;
  for (int i = 0; i < 8; ++i) {
    data.positions.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                (i & 4) != 0 ? 1 : -1);
  }
  add_quad(data, 0, 4, 6, 2);  // x = -1
  add_quad(data, 1, 3, 7, 5);
  add_quad(data, 0, 1, 5, 4);  // y = -1
  add_quad(data, 2, 6, 7, 3);
  add_quad(data, 0, 2, 3, 1);  // z = -1
  add_quad(data, 4, 5, 7, 6);
  return mesh_of(std::move(data));
}

Mesh sphere_mesh(int cuts) {
  MeshData data;
  for (int octant = 0; octant < 8; ++octant) {
    const Vec3 x((octant & 1) != 0 ? 1 : -1, 0, 0);
    const Vec3 y(0, (octant & 2) != 0 ? 1 : -1, 0);
    const Vec3 z(0, 0, (octant & 4) != 0 ? 1 : -1);
    const bool right_handed = x.x * y.y * z.z > 0;
    add_cut(data, x, right_handed ? y : z, right_handed ? z : y, cuts);
  }
  return mesh_of(std::move(data));
}

Mesh torus_mesh(int along, int around) {
  MeshData data;
  for (int i = 0; i < along; ++i) {
    const double u = 2 * std::numbers::pi * i / along;
    for (int k = 0; k < around; ++k) {
      const double v = 2 * std::numbers::pi * k / around;
      const double rho = 1 + 0.4 * std::cos(v);
      data.positions.emplace_back(rho * std::cos(u), 0.4 * std::sin(v), rho * std::sin(u));
    }
  }
  const auto at = [&](int i, int k) {
    return static_cast<std::uint32_t>(i % along * around + k % around);
  };
  for (int i = 0; i < along; ++i) {
    for (int k = 0; k < around; ++k) {
      add_quad(data, at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
    }
  }
  return mesh_of(std::move(data));
}

}  // namespace rt::stability
