// The programs compiled for other processors, and the one that chooses among them.
#include <filesystem>

#include "program.h"

namespace rt::test {
namespace {

/// All that packets of samples serve, and enough things for a hierarchy.
const char* const scene = R"(
local scene = gr.node("scene")
local function put(shape, colour, more)
  local m = {kd = colour, ks = 0.3, shininess = 20}
  for key, value in pairs(more or {}) do m[key] = value end
  scene:add_child(shape:set_material(gr.material(m)))
  return shape
end
put(gr.plane("floor"), {0.7, 0.7, 0.6})
put(gr.torus("ring", 1, 0.3), {0.8, 0.5, 0.1}):rotate('x', 70):translate(-1.5, 1, 0)
put(gr.sphere("mirror"), {0.1, 0.1, 0.1}, {reflectivity = 0.8}):translate(1, 1, -1)
put(gr.sphere("glass"), {0, 0, 0}, {ior = 1.5, opacity = 0}):scale(0.7):translate(0.2, 0.7, 1.5)
put(gr.cube("box"), {0.2, 0.3, 0.8}):rotate('y', 30):translate(1.8, 0, 0.8)
put(gr.blob("gumdrop"), {0.8, 0.2, 0.2}):scale(0.5):translate(-0.5, 0.5, 1.6)
put(gr.cylinder("post"), {0.3, 0.7, 0.3}):scale(0.2, 1.5, 0.2):translate(-2.2, 0, 1.5)
for i = 0, 120 do
  put(gr.nh_sphere("bead", {i % 11 * 0.4 - 2, 0.1, 2.4 + i // 11 * 0.3}, 0.1), {0.5, 0.6, 0.7})
end
gr.render{scene = scene, file = "p.png", size = {120, 90}, max_depth = 5,
  camera = {eye = {0, 3, 8}, look_at = {0, 0.7, 0}, fov = 35}, ambient = 0.2,
  lights = {gr.light({-4, 6, 5}, {0.8, 0.8, 0.7}, {1, 0, 0}),
            gr.light{position = {3, 5, 3}, colour = {0.4, 0.4, 0.5}, radius = 0.5}},
  background = {top = {0.1, 0.2, 0.5}, bottom = {0.7, 0.7, 0.8}}}
)";

using Processors = ProgramTest;

bool built_for(const char* level) {
  return std::filesystem::exists(std::string(RT_PROGRAM) + "-" + level);
}

TEST_F(Processors, GiveTheSameBytes) {
  write("scene.lua", scene);
  int levels = 0;
  for (const char* level : {"v2", "v3", "v4"}) {
    if (!built_for(level)) {
      continue;
    }
    const std::string file = std::string(level) + ".png";
    const Outcome o =
        run("scene.lua -q --max-error 0.01 -o " + file, std::string("RT_CPU=") + level);
    if (o.err.find("but this processor lacks") != std::string::npos) {
      continue;
    }
    ASSERT_EQ(o.exit_code, 0) << level << o.err;
    ++levels;
    EXPECT_TRUE(levels == 1 || same_file(folder_ / file, folder_ / "first.png")) << level;
    std::filesystem::copy_file(folder_ / file, folder_ / "first.png",
                               std::filesystem::copy_options::skip_existing);
  }
  EXPECT_GE(levels, built_for("v2") ? 2 : 1);
}

TEST_F(Processors, WithoutTheirProgramsTheLauncherSaysSo) {
  std::filesystem::copy_file(RT_PROGRAM, folder_ / "alone");
  const std::string command = "cd " + folder_.string() + " && ./alone --version 2>stderr.txt";
  EXPECT_NE(std::system(command.c_str()), 0);
  const std::string err = contents(folder_ / "stderr.txt");
  EXPECT_NE(err.find("none of " + (folder_ / "alone-v2").string()), std::string::npos) << err;
  EXPECT_EQ(err.find("too old"), std::string::npos) << err;
}

TEST_F(Processors, AreNamedRightOrRefused) {
  const Outcome o = run("--version", "RT_CPU=v9");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_NE(o.err.find("RT_CPU is 'v9'; expected v2, v3 or v4"), std::string::npos) << o.err;
  EXPECT_EQ(run("--version").exit_code, 0);
}

}  // namespace
}  // namespace rt::test
