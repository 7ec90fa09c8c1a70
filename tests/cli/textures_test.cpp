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

}  // namespace
}  // namespace rt::test
