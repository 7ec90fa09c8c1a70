#pragma once
#include <filesystem>
#include <memory>

#include "rt/geometry/mesh.h"

namespace rt::io {

/// Reads a Wavefront OBJ: v, vt, vn, f with a, a/b, a/b/c and a//c corners, negative indices,
/// polygons fanned; materials ignored. Throws FileError when it cannot be read, SceneError (with
/// the file's name, and the line where known) when it has no triangle, an index out of range, or a
/// number that is not finite.
std::shared_ptr<const MeshData> load_obj(const std::filesystem::path& path);

}  // namespace rt::io
