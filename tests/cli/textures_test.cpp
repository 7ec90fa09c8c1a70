// Pictures as textures, as a user meets them.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "program.h"

namespace rt::test {
namespace {

class TextureFiles : public ProgramTest {
 protected:
  Outcome textured(const std::string& call, const std::string& options = "") const {
    return run_script(sphere_script("local t = " + call + "\nball:set_texture(t)"), options);
  }
  /// The call stands in line 3.
  void expect_refused(const std::string& file, const std::string& content,
                      const std::string& says) const {
    write(file, content);
    const Outcome outcome = textured("gr.texture('" + file + "')");
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("error: scene.lua:3:")) << outcome.err;
    EXPECT_NE(outcome.err.find("'" + file + "'"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 3) << outcome.err;
    EXPECT_FALSE(exists("ball.png"));
  }
};

/// 8 bits a channel, RGB; with `data` as what should be its compressed pixels.
std::string png_of(const std::string& size, const std::string& data) {
  return std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16) + size + size +
         std::string("\x08\x02\0\0\0", 5) + "crc." + data;
}

TEST_F(TextureFiles, BadOnesMakeOneMessage) {
  expect_refused("empty.png", "", "empty");
  expect_refused("text.jpg", "no picture at all, but some words", "expected a PNG, JPEG");
  expect_refused("moving.gif", "GIF89a, and so on and so forth", "GIF; save it as PNG");
  expect_refused("bomb.png", png_of(std::string("\0\0\xea\x60", 4), std::string(70'000, 'x')),
                 "60000 x 60000");
  expect_refused("nothing.png", png_of(std::string(4, '\0'), ""), "0 x 0");
  // What only libpng finds, and would say on its own.
  expect_refused("broken.png", png_of(std::string("\0\0\0\x02", 4), "no chunk at all"),
                 "a PNG file");
  std::filesystem::create_directory(folder_ / "folder.png");
  EXPECT_EQ(textured("gr.texture('folder.png')").exit_code, 3);
}

TEST_F(TextureFiles, ShippedOnesAreFoundAndCounted) {
  for (const char* name : {"brick.jpg", "marble.jpg", "wood.jpg", "checker.png", "grid.png"}) {
    EXPECT_EQ(textured("gr.texture('" + std::string(name) + "')", "--samples 1").exit_code, 0);
  }
  const Outcome outcome = textured("gr.texture{file='grid.png', scale={2,2}, wrap='mirror'}",
                                   "--samples 1 --stats stats.json --texture-memory 64");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto stats = nlohmann::json::parse(contents(folder_ / "stats.json"));
  EXPECT_EQ(stats.at("textures").at("files"), 1);
  EXPECT_GT(stats.at("textures").at("load_seconds"), 0.0);
}

TEST_F(TextureFiles, AreNotCountedWhereThereAreNone) {
  EXPECT_EQ(run_script(sphere_script(), "--samples 1 --stats stats.json").exit_code, 0);
  EXPECT_FALSE(nlohmann::json::parse(contents(folder_ / "stats.json")).contains("textures"));
}

TEST_F(TextureFiles, KeepToTheSizeThatTheUserAllows) {
  const Outcome outcome = textured("gr.texture('brick.jpg')", "--max-texture-size 1023");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("at most 1023 a side"), std::string::npos) << outcome.err;
  EXPECT_EQ(textured("gr.texture('brick.jpg')", "--max-texture-size 0").exit_code, 2);
}

// The texture system keeps tiles of several threads in one cache and throws some away: lookups must
// not depend on which.
TEST_F(TextureFiles, GiveTheSamePictureForAnyNumberOfThreads) {
  write("scene.lua", R"(
local root = gr.node("root")
local function add(shape, texture)
  root:add_child(shape:set_material(gr.material(1, 0, 1)):set_texture(texture))
end
add(gr.plane("floor"), gr.texture("grid.png", {0.5, 0.5}))
add(gr.nh_sphere("ball", {-1, 1, 0}, 1), gr.texture("brick.jpg", {4, 2}))
add(gr.torus("ring", 0.7, 0.3):translate(1.3, 0.4, 0.5), gr.texture("marble.jpg"))
root:add_child(gr.nh_sphere("mirror", {1.2, 1.4, -1.5}, 1):set_material(
  gr.material{kd = 0.1, reflectivity = 0.8}))
gr.render{scene = root, file = "picture.png", size = {160, 120}, ambient = 0.4, samples = 4,
          camera = {eye = {0, 2, 7}, look_at = {0, 0.8, 0}, fov = 35},
          lights = {gr.light{position = {-3, 6, 5}, colour = 0.7}}}
)");
  for (const char* options : {"-t 1 -o one.png", "-t 8 -o eight.png --texture-memory 16"}) {
    const Outcome o = run(std::string("scene.lua -q ") + options);
    EXPECT_EQ(o.exit_code, 0) << o.err;
  }
  EXPECT_TRUE(same_file(folder_ / "one.png", folder_ / "eight.png"));
}

}  // namespace
}  // namespace rt::test
