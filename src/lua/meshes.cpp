/// gr.mesh: from a file, or from tables of vertices and faces.
#include <fmt/format.h>

#include "describe.h"
#include "files.h"
#include "functions.h"
#include "nodes.h"

namespace rt::lua {
namespace {

constexpr std::size_t max_vertices = 0xffff'ffffu;

template <class T>
std::size_t bytes_of(const std::vector<T>& list) {
  return list.capacity() * sizeof(T);
}

/// The same mesh, charged for.
std::shared_ptr<const MeshData> charged(lua_State* L, std::shared_ptr<const MeshData> mesh) {
  const std::size_t bytes = bytes_of(mesh->positions) + bytes_of(mesh->triangles) +
                            bytes_of(mesh->normals) + bytes_of(mesh->triangle_normals) +
                            bytes_of(mesh->uvs) + bytes_of(mesh->triangle_uvs);
  const MeshData* data = mesh.get();
  return {make_charged(L, std::move(mesh), bytes), data};
}

std::shared_ptr<const MeshData> mesh_of_file(const Call& call, const std::string& name) {
  Context& run = call.run();
  const FoundFile file = find_file(call, name, run.mesh_folders);
  auto& mesh = run.meshes[file.real];
  if (!mesh) {
    {
      // While it is being read a file takes a few times its size.
      std::error_code error;
      const auto bytes = std::filesystem::file_size(file.real, error);
      Charge reading(run.memory);
      charge(call.L, reading, error ? 0 : 3 * bytes);
    }
    mesh = charged(call.L, run.host.load_mesh(file.shown));  // shown: so do its messages
  }
  return mesh;
}

/// The length of the list at `value`; calls each(i) with item i, from 1, on top of the stack.
template <class Each>
std::size_t for_each_item(const Value& value, std::string_view expected, Each each) {
  if (value.type() != LUA_TTABLE) {
    value.fail(expected);
  }
  lua_State* L = value.call().L;
  const std::size_t size = lua_rawlen(L, value.index());
  if (size == 0 || size > max_vertices) {
    value.fail(expected);
  }
  for (std::size_t i = 1; i <= size; ++i) {
    lua_rawgeti(L, value.index(), static_cast<lua_Integer>(i));
    each(i);
    lua_pop(L, 1);
  }
  return size;
}

std::vector<Vec3> read_vertices(const Value& vertices) {
  const Call& call = vertices.call();
  std::vector<Vec3> positions;
  Charge cost(call.run().memory);
  charge(call.L, cost,
         (vertices.type() == LUA_TTABLE ? lua_rawlen(call.L, vertices.index()) : 0) * sizeof(Vec3));
  for_each_item(vertices, "a list of vertices {{x, y, z}, ...}", [&](std::size_t i) {
    const std::string name = fmt::format("vertex {}", i - 1);
    positions.push_back(Value(call, lua_gettop(call.L), "", name).triple());
  });
  return positions;
}

/// Corner `i` of the face on top of the stack, checked.
std::uint32_t read_corner(const Call& call, std::size_t face, std::size_t i, std::size_t vertices) {
  lua_State* L = call.L;
  lua_rawgeti(L, -1, static_cast<lua_Integer>(i));
  const double index = lua_tonumber(L, -1);
  if (lua_type(L, -1) != LUA_TNUMBER || !(index >= 0 && index < static_cast<double>(vertices)) ||
      index != static_cast<double>(static_cast<std::uint32_t>(index))) {
    call.fail(
        fmt::format("corner {} of face {}: expected a vertex from 0 to {} (the first is 0), got {}",
                    i, face, vertices - 1, describe(L, -1)));
  }
  lua_pop(L, 1);
  return static_cast<std::uint32_t>(index);
}

std::vector<Corners> read_faces(const Value& faces, std::size_t vertices) {
  const Call& call = faces.call();
  lua_State* L = call.L;
  std::vector<Corners> triangles;
  Charge cost(call.run().memory);  // face by face: one table may stand for a thousand of them
  for_each_item(faces, "a list of faces {{0, 1, 2}, ...}", [&](std::size_t face) {
    const std::size_t corners = lua_istable(L, -1) ? lua_rawlen(L, -1) : 0;
    if (corners < 3) {
      call.fail(fmt::format("face {}: expected three or more vertices {{0, 1, 2}}, got {}", face,
                            describe(L, -1)));
    }
    charge(L, cost, 2 * (corners - 2) * sizeof(Corners));
    const std::uint32_t first = read_corner(call, face, 1, vertices);
    std::uint32_t previous = read_corner(call, face, 2, vertices);
    for (std::size_t i = 3; i <= corners; ++i) {
      const std::uint32_t next = read_corner(call, face, i, vertices);
      triangles.push_back({first, previous, next});
      previous = next;
    }
  });
  return triangles;
}

}  // namespace

int make_mesh(Call& call) {
  luaL_checkstack(call.L, 4, nullptr);
  call.argument(1).text("a name (string)");
  const Value source = call.argument(2, "file or vertices");
  std::shared_ptr<const MeshData> mesh;
  if (source.type() == LUA_TTABLE) {
    auto data = std::make_shared<MeshData>();
    data->positions = read_vertices(source);
    data->triangles = read_faces(call.argument(3, "faces"), data->positions.size());
    arrange(*data);
    mesh = charged(call.L, std::move(data));
  } else {
    call.takes_at_most(2);
    mesh = mesh_of_file(call, source.text("a file name or a list of vertices"));
  }
  return push_new_node(call, make_charged(call.L, Shape(Mesh{std::move(mesh)})));
}

}  // namespace rt::lua
