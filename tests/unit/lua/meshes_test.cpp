#include "script_run.h"

namespace rt::lua {
namespace {

class Meshes : public ScriptTest {
 protected:
  std::shared_ptr<const MeshData> made(const std::string& arguments) {
    return shape_of<Mesh>("gr.mesh('m', " + arguments + ")").data;
  }
  const std::string quad_ = "{{0,0,0}, {1,0,0}, {1,1,0}, {0,1,0}}";
};

TEST_F(Meshes, PolygonsAreFanned) {
  const auto mesh = made(quad_ + ", {{0, 1, 2, 3}, {3.0, 2, 1}}");
  ASSERT_EQ(mesh->positions.size(), 4u);
  EXPECT_EQ(mesh->positions[2], Vec3(1, 1, 0));
  ASSERT_EQ(mesh->triangles.size(), 3u);
  EXPECT_EQ(mesh->triangles[0], (Corners{0, 1, 2}));
  EXPECT_EQ(mesh->triangles[1], (Corners{0, 2, 3}));
  EXPECT_EQ(mesh->triangles[2], (Corners{3, 2, 1}));
}

TEST_F(Meshes, BadTablesAreExplained) {
  expect_error("gr.mesh('m', " + quad_ + ", {{0, 1, 2}, {0, 1, 4}})",
               "scene.lua:1: gr.mesh: corner 3 of face 2: expected a vertex from 0 to 3 (the first "
               "is 0), got a number (4)");
  for (const std::string corner : {"-1", "1.5", "'1'", "0/0", "1e300", "{}"}) {
    expect_error("gr.mesh('m', " + quad_ + ", {{0, " + corner + ", 2}})",
                 "scene.lua:1: gr.mesh: corner 2 of face 1: ");
  }
  expect_error("gr.mesh('m', " + quad_ + ", {{0, 1}})",
               "scene.lua:1: gr.mesh: face 1: ", {"three or more"});
  expect_error("gr.mesh('m', " + quad_ + ", {7})",
               "scene.lua:1: gr.mesh: face 1: ", {"got a number (7)"});
  expect_error("gr.mesh('m', " + quad_ + ", {})",
               "scene.lua:1: gr.mesh: ", {"argument 3 (faces), got an empty table"});
  expect_error("gr.mesh('m', " + quad_ + ")",
               "scene.lua:1: gr.mesh: ", {"argument 3 (faces), got nothing"});
  expect_error("gr.mesh('m', {}, {{0, 1, 2}})",
               "scene.lua:1: gr.mesh: ", {"a list of vertices", "an empty table"});
  expect_error("gr.mesh('m', {{0, 0, 0}, {0, 0}}, {{0, 1, 0}})",
               "scene.lua:1: gr.mesh: ", {"'vertex 1'", "item 3 is nil"});
  expect_error("gr.mesh('m', 5)",
               "scene.lua:1: gr.mesh: ", {"a file name or a list of vertices", "(5)"});
  expect_error("gr.mesh(5, 'm')", "scene.lua:1: gr.mesh: expected a name (string) as argument 1");
}

TEST_F(Meshes, FilesOfTheScriptsFolderAreLoadedOnce) {
  write("meshes/cow.obj", "v 0 0 0");
  run("gr.mesh('a', 'meshes/cow.obj'); gr.mesh('b', './meshes/cow.obj')");
  ASSERT_EQ(loaded_.size(), 1u);
  EXPECT_EQ(real_[0], std::filesystem::canonical(folder_ / "meshes/cow.obj"));
}

TEST_F(Meshes, TheWorkingFolderComesSecond) {
  const auto before = std::filesystem::current_path();
  write("scenes/in_both.obj", "");
  write("in_both.obj", "");
  write("only_here.obj", "");
  write("scenes/scene.lua", "gr.mesh('a', 'in_both.obj')\ngr.mesh('b', 'only_here.obj')");
  std::filesystem::current_path(folder_);
  EXPECT_NO_THROW(run_script("scenes/scene.lua", {}, host_));
  std::filesystem::current_path(before);
  ASSERT_EQ(loaded_.size(), 2u);
  EXPECT_EQ(real_[0], std::filesystem::canonical(folder_ / "scenes/in_both.obj"));
  EXPECT_EQ(loaded_[0], "scenes/in_both.obj") << "as the user would write it";
  EXPECT_EQ(real_[1], std::filesystem::canonical(folder_ / "only_here.obj"));
}

TEST_F(Meshes, EachFolderOfTheFrameworksIsSearched) {
  const std::vector<std::string> folders{"set/scenes",  "work", "set/scenes/Assets",
                                         "work/Assets", "set",  "set/Assets"};
  std::string text;
  std::vector<std::filesystem::path> expected;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const std::string name = "mesh" + std::to_string(i) + ".obj";
    write(folders[i] + "/" + name, "");
    text += "gr.mesh('m', '" + name + "')\n";
    expected.push_back(std::filesystem::canonical(folder_ / folders[i] / name));
  }
  write("set/scenes/scene.lua", text);
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_ / "work");
  EXPECT_NO_THROW(run_script("../set/scenes/scene.lua", {}, host_));
  std::filesystem::current_path(before);
  EXPECT_EQ(real_, expected);
}

TEST_F(Meshes, AMissingFileIsAFileError) {
  expect_error("gr.mesh('m', 'cow.obj')", "scene.lua:1: gr.mesh: there is no file 'cow.obj' in ",
               {}, ExitCode::file);
  std::filesystem::create_directory(folder_ / "dir.obj");
  expect_error("gr.mesh('m', 'dir.obj')",
               "scene.lua:1: gr.mesh: cannot read 'dir.obj': it is a folder", {}, ExitCode::file);
}

TEST_F(Meshes, FilesOutsideAreRefused) {
  for (const std::string name : {"/etc/passwd", "../../../../../etc/passwd", "/dev/zero"}) {
    expect_error("gr.mesh('m', '" + name + "')",
                 "scene.lua:1: gr.mesh: '" + name + "' lies outside");
  }
  std::filesystem::create_symlink("/etc/passwd", folder_ / "link.obj");
  expect_error("gr.mesh('m', 'link.obj')", "scene.lua:1: gr.mesh: 'link.obj' lies outside");
  expect_error("gr.mesh('m', 'scene.lua\\0.obj')", "scene.lua:1: ", {}, ExitCode::file);
  EXPECT_TRUE(loaded_.empty());
}

}  // namespace
}  // namespace rt::lua
