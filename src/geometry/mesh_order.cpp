#include <algorithm>
#include <cmath>
#include <utility>

#include "rt/geometry/mesh.h"
#include "rt/math/arranged.h"

namespace rt {
namespace {

/// Cells of the curve along each axis: 2^21, so that a place on it takes 63 bits.
constexpr int curve_bits = 21;

/// Bit i of 21 bits as bit 3 i (Morton, "A computer oriented geodetic data base", 1966).
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffffU;
  x = (x | x << 16) & 0x001f0000ff0000ffU;
  x = (x | x << 8) & 0x100f00f00f00f00fU;
  x = (x | x << 4) & 0x10c30c30c30c30c3U;
  return (x | x << 2) & 0x1249249249249249U;
}

/// A place in [0,1]^3 along Morton's curve; NaN as 0.
std::uint64_t along_curve(const Vec3& place) {
  std::uint64_t code = 0;
  for (int k = 0; k < 3; ++k) {
    const double cell = std::ldexp(place[k], curve_bits);
    const double last = std::ldexp(1.0, curve_bits) - 1.0;
    code |= spread(static_cast<std::uint64_t>(cell > 0.0 ? std::min(cell, last) : 0.0)) << k;
  }
  return code;
}

/// Triangles by their places along the curve; equal places by their indices.
using Order = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

void permute(std::vector<Corners>& corners, const Order& order) {
  if (corners.empty()) {
    return;
  }
  std::vector<Corners> permuted;
  permuted.reserve(corners.size());
  for (const auto& [place, triangle] : order) {
    permuted.push_back(corners[triangle]);
  }
  corners = std::move(permuted);
}

template <class T>
void arrange_by_use(std::vector<T>& table, std::vector<Corners>& users) {
  arrange_table(table, [&](auto&& visit) {
    for (Corners& corners : users) {
      for (std::uint32_t& corner : corners) {
        visit(corner);
      }
    }
  });
}

}  // namespace

void arrange(MeshData& mesh) {
  Bounds all;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    all.extend(triangle_bounds(mesh, i));
  }
  const double size = max_abs(all.extent());
  Order order;
  order.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3 middle = mesh.positions[a] / 3.0 + mesh.positions[b] / 3.0 + mesh.positions[c] / 3.0;
    order.emplace_back(along_curve((middle - all.lo) / size), i);
  }
  std::ranges::sort(order);
  permute(mesh.triangles, order);
  permute(mesh.triangle_normals, order);
  permute(mesh.triangle_uvs, order);
  arrange_by_use(mesh.positions, mesh.triangles);
  arrange_by_use(mesh.normals, mesh.triangle_normals);
  arrange_by_use(mesh.uvs, mesh.triangle_uvs);
}

}  // namespace rt
