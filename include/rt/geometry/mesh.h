#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "rt/geometry/hit.h"
#include "rt/math/bounds.h"

namespace rt {

/// Indices of a triangle's corners into one of MeshData's arrays.
using Corners = std::array<std::uint32_t, 3>;

/// Triangles with shared vertices, as a file or a script gave them. Every index is valid.
struct MeshData {
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  /// Vertex normals (unit) and the corners' indices into them; both empty where none were given.
  std::vector<Vec3> normals;
  std::vector<Corners> triangle_normals;
  /// Texture coordinates, likewise.
  std::vector<Vec2> uvs;
  std::vector<Corners> triangle_uvs;
};

/// Puts side by side in memory what is side by side in space, for rays to find it in fewer places:
/// triangles in the order of a curve through all their middles, corners in that of the triangles.
/// What no triangle uses is left out.
void arrange(MeshData& mesh);

/// A triangle mesh. Feature: the triangle's index. The geometric normal follows the corners'
/// counter-clockwise order. intersect() over the whole mesh tries every triangle in turn; the
/// renderer walks a hierarchy instead and calls intersect_triangle().
struct Mesh {
  std::shared_ptr<const MeshData> data;
};

/// One triangle, watertight: a ray through a shared edge hits at least one of its two triangles.
OptionalHit intersect_triangle(const MeshData& mesh, std::uint32_t triangle, const Ray& ray,
                               double t_max, const RayStart& start);
Bounds triangle_bounds(const MeshData& mesh, std::uint32_t triangle);

OptionalHit intersect(const Mesh& shape, const Ray& ray, double t_max, const RayStart& start);
SurfacePoint surface_point(const Mesh& shape, const Ray& ray, const ShapeHit& hit);
SurfaceCoordinates surface_coordinates(const Mesh& shape, const SurfacePoint& point,
                                       std::uint32_t feature);
Vec3 normal_change(const Mesh& shape, const SurfacePoint& point, std::uint32_t feature,
                   const Vec3& step);
Bounds bounds(const Mesh& shape);

}  // namespace rt
