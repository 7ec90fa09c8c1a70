#include "rt/io/obj.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "obj_text.h"
#include "rt/scene/error.h"

namespace rt::io {
namespace {

/// What is wrong with a face; the caller knows the line.
struct FaceError {
  std::size_t face;
  std::string text;
};

/// Normals as the mesh wants them: of unit length, or zero.
std::vector<Vec3> normalised(std::vector<Vec3> normals) {
  for (Vec3& normal : normals) {
    // Scaled first: the square of a huge or tiny component leaves the range of double.
    const double scale = max_abs(normal);
    normal = scale > 0.0 ? glm::normalize(normal / scale) : Vec3(0.0);
  }
  return normals;
}

/// Makes triangles of the faces that tinyobjloader calls out. Its numbers are not used: it takes
/// what it does not understand for zero, which makes a wrong picture instead of a message, and
/// reads 0.75 as 0.7500000000000001. Corners without a normal or a texture coordinate are marked,
/// and filled once it is known whether any has one.
class Builder {
 public:
  explicit Builder(ObjPoints points) {
    mesh.positions = std::move(points.positions);
    mesh.normals = normalised(std::move(points.normals));
    mesh.uvs.assign(points.uvs.begin(), points.uvs.end());
  }

  void add_face(std::span<const tinyobj::index_t> corners) {
    const std::size_t face = faces_++;
    if (corners.size() < 3) {
      return;  // a point or a line: no surface
    }
    polygon_.clear();
    for (const auto& corner : corners) {
      polygon_.push_back(
          {resolve(corner.vertex_index, so_far.positions, mesh.positions.size(), "vertex", face),
           resolve_optional(corner.texcoord_index, so_far.uvs, mesh.uvs.size(),
                            "texture coordinate", face),
           resolve_optional(corner.normal_index, so_far.normals, mesh.normals.size(), "normal",
                            face)});
    }
    for (std::size_t i = 2; i < polygon_.size(); ++i) {
      const std::array fan{polygon_[0], polygon_[i - 1], polygon_[i]};
      mesh.triangles.push_back({fan[0].vertex, fan[1].vertex, fan[2].vertex});
      mesh.triangle_uvs.push_back({fan[0].uv, fan[1].uv, fan[2].uv});
      mesh.triangle_normals.push_back({fan[0].normal, fan[1].normal, fan[2].normal});
    }
  }

  /// Gives every triangle normals and texture coordinates, or drops them where none has any.
  void finish() {
    const auto has_normals = [&](const Corners& corners) {
      return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
        return corner != none && mesh.normals[corner] != Vec3(0.0);
      });
    };
    if (std::none_of(mesh.triangle_normals.begin(), mesh.triangle_normals.end(), has_normals)) {
      mesh.normals.clear();
      mesh.triangle_normals.clear();
    }
    for (std::size_t i = 0; i < mesh.triangle_normals.size(); ++i) {
      if (!has_normals(mesh.triangle_normals[i])) {
        mesh.triangle_normals[i].fill(static_cast<std::uint32_t>(mesh.normals.size()));
        mesh.normals.push_back(flat_normal(mesh.triangles[i]));
      }
    }
    const auto has_uvs = [](const Corners& corners) {
      return std::find(corners.begin(), corners.end(), none) == corners.end();
    };
    if (std::none_of(mesh.triangle_uvs.begin(), mesh.triangle_uvs.end(), has_uvs)) {
      mesh.uvs.clear();
      mesh.triangle_uvs.clear();
    }
    std::optional<std::uint32_t> origin;
    for (Corners& corners : mesh.triangle_uvs) {
      if (!has_uvs(corners)) {
        if (!origin) {
          origin = static_cast<std::uint32_t>(mesh.uvs.size());
          mesh.uvs.emplace_back(0.0);
        }
        corners.fill(*origin);
      }
    }
  }

  MeshData mesh;
  /// Statements passed, from where negative indices count backwards.
  struct {
    std::size_t positions = 0, uvs = 0, normals = 0;
  } so_far;

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  struct Corner {
    std::uint32_t vertex, uv, normal;
  };

  /// From OBJ's index to ours: from 1 over the whole file, or backwards from what stands before the
  /// face.
  static std::uint32_t resolve(int index, std::size_t so_far, std::size_t all, const char* what,
                               std::size_t face) {
    if (index == 0) {
      throw FaceError{
          face, fmt::format("expected the index of a {}, from 1 to {} or negative", what, all)};
    }
    const std::int64_t resolved =
        index > 0 ? std::int64_t{index} - 1 : static_cast<std::int64_t>(so_far) + index;
    if (resolved < 0 || resolved >= static_cast<std::int64_t>(all)) {
      throw FaceError{face, fmt::format("the face asks for {} {}, but the file has {}", what, index,
                                        index > 0 ? all : so_far)};
    }
    return static_cast<std::uint32_t>(resolved);
  }

  static std::uint32_t resolve_optional(int index, std::size_t so_far, std::size_t all,
                                        const char* what, std::size_t face) {
    return index == 0 ? none : resolve(index, so_far, all, what, face);
  }

  Vec3 flat_normal(const Corners& corners) const {
    const Vec3 u = mesh.positions[corners[1]] - mesh.positions[corners[0]];
    const Vec3 v = mesh.positions[corners[2]] - mesh.positions[corners[0]];
    const double u_scale = max_abs(u);
    const double v_scale = max_abs(v);
    if (u_scale > 0.0 && v_scale > 0.0 && std::isfinite(u_scale) && std::isfinite(v_scale)) {
      const Vec3 normal = glm::cross(u / u_scale, v / v_scale);
      if (max_abs(normal) > 0.0) {
        return glm::normalize(normal);
      }
    }
    return {0.0, 1.0, 0.0};  // a triangle without area is never hit: any unit vector serves
  }

  std::size_t faces_ = 0;
  std::vector<Corner> polygon_;
};

Builder& builder(void* user) { return *static_cast<Builder*>(user); }

tinyobj::callback_t callbacks() {
  tinyobj::callback_t calls;
  calls.vertex_cb = [](void* user, double, double, double, double) {
    ++builder(user).so_far.positions;
  };
  calls.normal_cb = [](void* user, double, double, double) { ++builder(user).so_far.normals; };
  calls.texcoord_cb = [](void* user, double, double, double) { ++builder(user).so_far.uvs; };
  calls.index_cb = [](void* user, tinyobj::index_t* corners, int count) {
    builder(user).add_face({corners, static_cast<std::size_t>(count)});
  };
  return calls;
}

}  // namespace

std::shared_ptr<const MeshData> load_obj(const std::filesystem::path& path) {
  std::istringstream stream(read_obj_text(path));
  const std::string_view text = stream.view();
  Builder built(read_obj_points(text, path));
  try {
    tinyobj::LoadObjWithCallback(stream, callbacks(), &built, nullptr, nullptr, nullptr);
  } catch (const FaceError& error) {
    throw SceneError(
        fmt::format("{}:{}: {}", path.string(), line_of_face(text, error.face), error.text));
  }
  if (built.mesh.triangles.empty()) {
    throw SceneError(
        fmt::format("{} ({} bytes): expected at least one face (a line such as 'f 1 2 3') in the "
                    "OBJ file, got none",
                    path.string(), text.size()));
  }
  built.finish();
  arrange(built.mesh);
  return std::make_shared<const MeshData>(std::move(built.mesh));
}

}  // namespace rt::io
