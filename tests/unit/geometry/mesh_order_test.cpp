// Meshes arranged in space: the same triangles, in an order that does not depend on the one given.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

#include "rt/geometry/mesh.h"

namespace rt::testing {
namespace {

constexpr std::uint32_t n = 64;

/// n x n cells of two triangles each; every triangle with its own normals, coordinates by vertex.
MeshData sheet() {
  MeshData mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j) {
      mesh.positions.emplace_back(i, std::sin(0.3 * i) * std::cos(0.2 * j), j);
      mesh.uvs.emplace_back(1.0 / (1 + i), 1.0 / (1 + j));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j;
      for (const Corners& corners : {Corners{a, a + 1, a + n + 1}, {a + 1, a + n + 2, a + n + 1}}) {
        mesh.triangles.push_back(corners);
        mesh.triangle_uvs.push_back(corners);
        const auto normal = static_cast<std::uint32_t>(mesh.normals.size());
        mesh.normals.push_back(glm::normalize(Vec3(i, 1.0, j)));
        mesh.triangle_normals.push_back({normal, normal, normal});
      }
    }
  }
  return mesh;
}

std::vector<std::uint32_t> shuffled_indices(std::size_t count, std::mt19937_64& engine) {
  std::vector<std::uint32_t> to(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    to[i] = i;
  }
  std::ranges::shuffle(to, engine);
  return to;
}

/// Entries moved anywhere, and a few added that nobody uses.
template <class T>
void shuffle_table(std::vector<T>& table, std::vector<Corners>& users, std::mt19937_64& engine) {
  const std::size_t used = table.size();
  const std::vector<std::uint32_t> to = shuffled_indices(used + 5, engine);
  std::vector<T> moved(to.size(), T(1e6));
  for (std::size_t i = 0; i < used; ++i) {
    moved[to[i]] = table[i];
  }
  table = std::move(moved);
  for (Corners& corners : users) {
    for (std::uint32_t& corner : corners) {
      corner = to[corner];
    }
  }
}

MeshData shuffled(const MeshData& mesh) {
  std::mt19937_64 engine(3);
  MeshData out = mesh;
  const std::vector<std::uint32_t> to = shuffled_indices(mesh.triangles.size(), engine);
  for (std::size_t i = 0; i < to.size(); ++i) {
    out.triangles[to[i]] = mesh.triangles[i];
    out.triangle_normals[to[i]] = mesh.triangle_normals[i];
    out.triangle_uvs[to[i]] = mesh.triangle_uvs[i];
  }
  shuffle_table(out.positions, out.triangles, engine);
  shuffle_table(out.normals, out.triangle_normals, engine);
  shuffle_table(out.uvs, out.triangle_uvs, engine);
  return out;
}

/// A triangle by what it looks like, to be sorted.
using Look = std::vector<double>;
std::vector<Look> looks(const MeshData& mesh) {
  std::vector<Look> out;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Look look;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[mesh.triangles[i][k]];
      const Vec3& normal = mesh.normals[mesh.triangle_normals[i][k]];
      const Vec2& uv = mesh.uvs[mesh.triangle_uvs[i][k]];
      look.insert(look.end(), {p.x, p.y, p.z, normal.x, normal.y, normal.z, uv.x, uv.y});
    }
    out.push_back(std::move(look));
  }
  std::ranges::sort(out);
  return out;
}

double mean_step(const MeshData& mesh) {
  double sum = 0.0;
  Vec3 last;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0;
    sum += i > 0 ? glm::length(middle - last) : 0.0;
    last = middle;
  }
  return sum / static_cast<double>(mesh.triangles.size() - 1);
}

TEST(MeshOrder, TheSameTrianglesWithTheirNormalsAndCoordinates) {
  const MeshData before = shuffled(sheet());
  MeshData after = before;
  arrange(after);
  EXPECT_EQ(looks(after), looks(before));
  EXPECT_EQ(after.positions.size(), (n + 1) * (n + 1)) << "what is not used is left out";
}

TEST(MeshOrder, DoesNotDependOnTheOrderGiven) {
  MeshData one = sheet();
  MeshData other = shuffled(one);
  arrange(one);
  arrange(other);
  EXPECT_EQ(one.positions, other.positions);
  EXPECT_EQ(one.triangles, other.triangles);
  EXPECT_EQ(one.normals, other.normals);
  EXPECT_EQ(one.triangle_normals, other.triangle_normals);
  EXPECT_EQ(one.uvs, other.uvs);
  EXPECT_EQ(one.triangle_uvs, other.triangle_uvs);
}

// Along Morton's curve three steps in four go to a cell beside or across a corner, one in sixteen
// twice as far as one in four, and so on: below 2 cells on the mean, even where two triangles share a
// cell. Anywhere in the sheet, the mean is half of its edge.
TEST(MeshOrder, NeighboursLieTogether) {
  MeshData mesh = shuffled(sheet());
  EXPECT_GT(mean_step(mesh), 0.4 * n);
  arrange(mesh);
  EXPECT_LT(mean_step(mesh), 2.0);
}

TEST(MeshOrder, MeshesWithoutAnExtent) {
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double size : {0.0, 1e-320, largest, infinity}) {
    MeshData mesh;
    mesh.positions = {{-size, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, -size, size}};
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 3, 2}};
    arrange(mesh);
    EXPECT_EQ(mesh.triangles.size(), 3u) << size;
    EXPECT_EQ(mesh.positions.size(), 4u) << size;
    EXPECT_EQ(mesh.triangles[0], (Corners{0, 1, 2})) << size;
  }
}

}  // namespace
}  // namespace rt::testing
