#pragma once
/// An OBJ file as text: its lines and the numbers of its points.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rt/math/vec.h"

namespace rt::io {

/// The whole file. Throws FileError.
std::string read_obj_text(const std::filesystem::path& path);

/// What v, vt and vn statements give.
struct ObjPoints {
  std::vector<Vec3> positions;
  std::vector<Vec3> uvs;
  std::vector<Vec3> normals;
};

/// The numbers of every v, vt and vn. Throws SceneError with file and line where one is missing or
/// not finite.
ObjPoints read_obj_points(std::string_view text, const std::filesystem::path& path);

/// The line (from 1) of the n-th f statement (from 0).
std::size_t line_of_face(std::string_view text, std::size_t n);

}  // namespace rt::io
