// Fuzz target: an OBJ file.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "rt/io/obj.h"
#include "rt/scene/error.h"

namespace {

/// Every index must be valid, every list of the same length or empty.
void check(const rt::MeshData& mesh) {
  const auto valid = [](const std::vector<rt::Corners>& triangles, std::size_t size) {
    for (const rt::Corners& corners : triangles) {
      for (const std::uint32_t corner : corners) {
        if (corner >= size) {
          std::abort();
        }
      }
    }
  };
  valid(mesh.triangles, mesh.positions.size());
  valid(mesh.triangle_normals, mesh.normals.size());
  valid(mesh.triangle_uvs, mesh.uvs.size());
  for (const auto* list : {&mesh.triangle_normals, &mesh.triangle_uvs}) {
    if (!list->empty() && list->size() != mesh.triangles.size()) {
      std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file = [] {
    char pattern[] = "/tmp/rt-fuzz-XXXXXX";
    return std::filesystem::path(mkdtemp(pattern)) / "mesh.obj";
  }();
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    check(*rt::io::load_obj(file));
  } catch (const rt::UserError&) {
  }
  return 0;
}
