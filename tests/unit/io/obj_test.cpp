#include "rt/io/obj.h"

#include <random>

#include "rt/scene/error.h"
#include "temp_folder.h"

namespace rt::io {
namespace {

using namespace std::string_literals;

constexpr const char* cube_vertices =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
constexpr const char* cube_faces =
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class Obj : public testing::Test {
 protected:
  MeshData load(const std::string& text) const {
    put(folder_ / "m.obj", text);
    return *load_obj(folder_ / "m.obj");
  }
  std::string error(const std::string& text) const {
    return message_of<SceneError>([&] { load(text); });
  }
  TempFolder folder_;
};

double enclosed_volume(const MeshData& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume +=
        glm::dot(mesh.positions[t[0]], glm::cross(mesh.positions[t[1]], mesh.positions[t[2]])) /
        6.0;
  }
  return volume;
}

TEST_F(Obj, FansTheQuadsOfACube) {
  const MeshData mesh = load(std::string("# a cube\n") + cube_vertices + cube_faces);
  EXPECT_EQ(mesh.positions.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_NEAR(enclosed_volume(mesh), 1.0, 1e-15);
  EXPECT_TRUE(mesh.normals.empty() && mesh.triangle_normals.empty());
  EXPECT_TRUE(mesh.uvs.empty() && mesh.triangle_uvs.empty());
}

TEST_F(Obj, ReadsWindowsAndOldMacLineEnds) {
  for (const std::string end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : std::string(cube_vertices) + cube_faces) {
      text += c == '\n' ? end : std::string(1, c);
    }
    EXPECT_EQ(load(text).triangles.size(), 12U);
  }
}

/// What a triangle's corners are.
template <class T>
std::array<T, 3> at(const Corners& corners, const std::vector<T>& table) {
  return {table.at(corners[0]), table.at(corners[1]), table.at(corners[2])};
}
std::array<Vec3, 3> points(const Vec3& a, const Vec3& b, const Vec3& c) { return {a, b, c}; }

TEST_F(Obj, CountsNegativeIndicesBackwards) {
  const MeshData mesh = load("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\n");
  EXPECT_EQ(at(mesh.triangles.at(0), mesh.positions), points({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
}

TEST_F(Obj, AllowsFacesBeforeTheirVertices) {
  EXPECT_EQ(load("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").triangles.at(0), (Corners{0, 1, 2}));
}

TEST_F(Obj, ReadsEveryFormOfACorner) {
  const std::string data =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0.5 1 0\nvn 0 0 2\nvn 0 3 0\nvn 1 0 0\n";
  const Vec3 x(1, 0, 0);
  const Vec3 y(0, 1, 0);
  const Vec3 z(0, 0, 1);  // normals have unit length
  const MeshData all = load(data + "f 1/2/3 2/3/1 3/1/2\n");
  EXPECT_EQ(at(all.triangle_uvs.at(0), all.uvs), (std::array<Vec2, 3>{{{1, 0}, {0.5, 1}, {0, 0}}}));
  EXPECT_EQ(at(all.triangle_normals.at(0), all.normals), points(x, z, y));

  const MeshData normals = load(data + "f 1//3 2//1 3//-1\n");
  EXPECT_EQ(at(normals.triangle_normals.at(0), normals.normals), points(x, z, x));
  EXPECT_TRUE(normals.uvs.empty() && normals.triangle_uvs.empty());

  const MeshData uvs = load(data + "f 1/1 2/2 3/-1\n");
  EXPECT_EQ(at(uvs.triangle_uvs.at(0), uvs.uvs), (std::array<Vec2, 3>{{{0, 0}, {1, 0}, {0.5, 1}}}));
  EXPECT_TRUE(uvs.normals.empty() && uvs.triangle_normals.empty());
}

TEST_F(Obj, GivesTrianglesWithoutNormalsTheirOwn) {
  const MeshData mesh = load(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 1 0 0\nvn 0 0 0\nvt 0.25 0.75\n"
      "f 1//1 2//1 3//1\nf 1//2 2//1 3//1\nf 1/1 2/1 3/1\n");
  ASSERT_EQ(mesh.triangle_normals.size(), 3U);
  EXPECT_EQ(mesh.normals[mesh.triangle_normals[0][0]], Vec3(1, 0, 0));
  for (std::size_t i : {1U, 2U}) {  // a zero-length normal counts as none
    EXPECT_EQ(mesh.normals[mesh.triangle_normals[i][0]], Vec3(0, 0, 1));
  }
  ASSERT_EQ(mesh.triangle_uvs.size(), 3U);
  EXPECT_EQ(mesh.uvs[mesh.triangle_uvs[2][0]], Vec2(0.25, 0.75));
  EXPECT_EQ(mesh.uvs[mesh.triangle_uvs[0][0]], Vec2(0.0, 0.0));
}

TEST_F(Obj, DropsNormalsThatAreAllZero) {
  const MeshData mesh = load("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n");
  EXPECT_TRUE(mesh.normals.empty() && mesh.triangle_normals.empty());
}

TEST_F(Obj, NormalisesHugeAndTinyNormals) {
  const MeshData mesh = load(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1e300 0 0\nvn 0 1e-300 0\n"
      "f 1//1 2//2 3//2\n");
  EXPECT_EQ(mesh.normals.at(0), Vec3(1, 0, 0));
  EXPECT_EQ(mesh.normals.at(1), Vec3(0, 1, 0));
}

TEST_F(Obj, IgnoresWhatIsNotGeometry) {
  const MeshData mesh = load(
      "mtllib none.mtl\no thing\ng a b\nusemtl red\ns 1\nv 0 0 0 1 0 0\nv 1 0 0 1.0\n"
      "v 0 1 0 # last\nl 1 2\np 1\nf 1 2\nf 1\nf\nfoo bar\nvp 1 2\nf 1 2 3\n");
  EXPECT_EQ(mesh.triangles.size(), 1U);
}

TEST_F(Obj, ReadsNumbersOfEveryForm) {
  const MeshData mesh = load("\xef\xbb\xbfv +.5 -1.5e+2 1E-3\nv 1. 1e-999 0\nv 0 1 0\nf 1 2 3");
  EXPECT_EQ(mesh.positions.at(0), Vec3(0.5, -150.0, 0.001));
  EXPECT_EQ(mesh.positions.at(1), Vec3(1.0, 0.0, 0.0));
}

TEST_F(Obj, NamesFileAndLineOfABrokenIndex) {
  const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1 2 3\n\n";
  for (const char* face : {"f 1 2 4", "f 1 2 0", "f 1 2 -4", "f 1 x 3", "f 1/1 2/1 3/1",
                           "f 1//2 2//1 3//1", "f 1 2 2147483647", "f 1 2 -2147483648"}) {
    const std::string message = error(head + face + "\n");
    EXPECT_NE(message.find("m.obj:7: "), std::string::npos) << face << ": " << message;
  }
}

TEST_F(Obj, RejectsNumbersThatAreNone) {
  for (const char* vertex :
       {"v nan 0 0", "v 0 inf 0", "v 0 0 1e999", "v 1 2", "v 1 2 3x", "v 1,0 0 0", "vn 0 0", "vt ",
        "vn 0 -inf 1", "v 1 2 +-3", "v 0x10 0 0"}) {
    const std::string message = error(std::string(cube_vertices) + cube_faces + vertex + "\n");
    EXPECT_NE(message.find("m.obj:15: "), std::string::npos) << vertex << ": " << message;
  }
}

TEST_F(Obj, SaysThatThereIsNoTriangle) {
  EXPECT_NE(error("").find("m.obj (0 bytes)"), std::string::npos);
  EXPECT_NE(error(cube_vertices).find("face"), std::string::npos);
  EXPECT_NE(error("f 1 2\nv 0 0 0\nv 0 0 1\n").find("face"), std::string::npos);
}

TEST_F(Obj, CannotReadWhatIsNoFile) {
  std::filesystem::create_directory(folder_ / "folder.obj");
  for (const auto& path :
       {folder_ / "missing.obj", folder_ / "folder.obj", std::filesystem::path("/dev/zero")}) {
    const auto message = message_of<FileError>([&] { load_obj(path); });
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  }
}

/// Whatever the bytes: a mesh whose indices are valid, or an error. Run under ASan it also shows
/// that no memory is touched that is not ours.
TEST_F(Obj, SurvivesGarbage) {
  std::mt19937 random(7);
  const std::string alphabet = "v vt vn f 1 2 3 -1 //0.5 e+#\\\r\n\n\n\t\0\xff nan usemtl g"s;
  for (int round = 0; round < 3000; ++round) {
    std::string text = round % 2 == 0 ? "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\n" : "";
    for (std::size_t i = random() % 200; i > 0; --i) {
      text += round % 3 == 0 ? static_cast<char>(random()) : alphabet[random() % alphabet.size()];
    }
    try {
      const MeshData mesh = load(text);
      for (const auto& t : mesh.triangles) {
        for (const auto corner : t) {
          ASSERT_LT(corner, mesh.positions.size());
        }
      }
    } catch (const SceneError&) {
    }
  }
}

/// A good file with single bytes changed gets further than noise does.
TEST_F(Obj, SurvivesDamage) {
  std::mt19937 random(11);
  const std::string good = std::string(cube_vertices) + "vt 0 0\nvn 0 0 1\n" + cube_faces +
                           "f 1/1/1 2/1/1 3/1/1\nf -1//-1 -2//-1 -3//-1\n";
  for (int round = 0; round < 3000; ++round) {
    std::string text = good;
    for (std::size_t i = 1 + random() % 3; i > 0; --i) {
      text[random() % text.size()] = static_cast<char>(random());
    }
    try {
      const MeshData mesh = load(text);
      ASSERT_TRUE(mesh.triangle_normals.empty() ||
                  mesh.triangle_normals.size() == mesh.triangles.size());
      for (const auto& t : mesh.triangle_normals) {
        for (const auto corner : t) {
          ASSERT_NEAR(glm::length(mesh.normals.at(corner)), 1.0, 1e-12);
        }
      }
    } catch (const SceneError&) {
    }
  }
}

}  // namespace
}  // namespace rt::io
