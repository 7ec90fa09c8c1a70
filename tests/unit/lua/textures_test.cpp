#include "rt/scene/texture.h"

#include "rt/scene/texture_image.h"
#include "script_run.h"

namespace rt::lua {
namespace {

struct FakeImage : TextureImage {
  explicit FakeImage(std::filesystem::path path) : path_(std::move(path)) {}
  const std::filesystem::path& file() const override { return path_; }
  Rgb value(const TextureFootprint&, Wrap, bool) const override { return Rgb(0.5); }
  TextureSample sample(const TextureFootprint&, Wrap, bool) const override { return {}; }
  std::filesystem::path path_;
};

class LuaTextures : public ScriptTest {
 protected:
  LuaTextures() {
    write("a.png", "not looked at");
    host_.open_texture = [this](const std::filesystem::path& path) {
      opened_.push_back(std::filesystem::canonical(path));
      return std::make_shared<const FakeImage>(path);
    };
  }
  ImageTexture made(const std::string& expression) {
    const auto& instance =
        instance_of_root("root = gr.sphere('s'):set_texture(" + expression + ")");
    return std::get<ImageTexture>(*(*instance.textures)[TextureSlot::kd].texture);
  }
  std::vector<std::filesystem::path> opened_;
};

TEST_F(LuaTextures, TakeAFile) {
  const ImageTexture t = made("gr.texture('a.png')");
  EXPECT_EQ(t.scale, Vec2(1.0));
  EXPECT_EQ(t.wrap, Wrap::repeat);
  EXPECT_EQ(t.image->file(), folder_ / "a.png");
}

TEST_F(LuaTextures, TakeAScale) {
  EXPECT_EQ(made("gr.texture('a.png', {2, -3})").scale, Vec2(2.0, -3.0));
  EXPECT_EQ(made("gr.texture('a.png', 4)").scale, Vec2(4.0));
}

TEST_F(LuaTextures, TakeNames) {
  const ImageTexture t = made("gr.texture{file='a.png', scale={5, 6}, wrap='mirror'}");
  EXPECT_EQ(t.scale, Vec2(5.0, 6.0));
  EXPECT_EQ(t.wrap, Wrap::mirror);
  EXPECT_EQ(made("gr.texture{file='a.png', wrap='clamp'}").wrap, Wrap::clamp);
  EXPECT_EQ(made("gr.texture{file='a.png', wrap='black'}").wrap, Wrap::black);
  EXPECT_EQ(made("gr.texture{file='a.png', wrap='repeat'}").wrap, Wrap::repeat);
}

TEST_F(LuaTextures, OpenAFileOnce) {
  write("sub/b.png", "x");
  run("gr.texture('a.png') gr.texture('sub/../a.png', 2) gr.texture('sub/b.png')");
  EXPECT_EQ(opened_, (std::vector{std::filesystem::canonical(folder_ / "a.png"),
                                  std::filesystem::canonical(folder_ / "sub/b.png")}));
}

TEST_F(LuaTextures, RefuseWhatMakesNoSense) {
  const std::string start = "scene.lua:1: gr.texture";
  expect_error("gr.texture()", start, {"file"});
  expect_error("gr.texture(5)", start, {"name of a picture file"});
  expect_error("gr.texture('a.png', 'big')", start, {"two numbers {u, v}", "\"big\""});
  expect_error("gr.texture('a.png', {1, 2, 3})", start, {"two numbers {u, v}"});
  expect_error("gr.texture('a.png', {1, 0})", start, {"two numbers {u, v}"});
  expect_error("gr.texture('a.png', {1, 0/0})", start, {"v"});
  expect_error("gr.texture{scale=1}", start, {"file"});
  expect_error("gr.texture{file='a.png', wrap='tile'}", start,
               {"'repeat', 'clamp', 'mirror' or 'black'", "\"tile\""});
  expect_error("gr.texture{file='a.png', warp='clamp'}", start, {"did you mean 'wrap'"});
}

TEST_F(LuaTextures, StayInTheirFolders) {
  expect_error("gr.texture('/etc/passwd')", "scene.lua:1: gr.texture", {"lies outside"});
  expect_error("gr.texture('../../etc/passwd')", "scene.lua:1: gr.texture", {"lies outside"});
  std::filesystem::create_symlink("/etc/passwd", folder_ / "link.png");
  expect_error("gr.texture('link.png')", "scene.lua:1: gr.texture", {"lies outside"});
  std::filesystem::create_symlink("/dev/zero", folder_ / "zero.png");
  expect_error("gr.texture('zero.png')", "scene.lua:1: gr.texture", {"lies outside"});
  expect_error("gr.texture('none.png')", "scene.lua:1: gr.texture", {"no file 'none.png'"},
               ExitCode::file);
  EXPECT_TRUE(opened_.empty());
}

TEST_F(LuaTextures, ComeWithTheProgram) {
  write("shipped/oak.jpg", "x");
  write("scenes/scene.lua", "gr.texture('oak.jpg')");
  settings_.shipped_textures = folder_ / "shipped";
  run_script(folder_ / "scenes/scene.lua", {}, host_, settings_);
  EXPECT_EQ(opened_.size(), 1U);
}

TEST_F(LuaTextures, TellWhereABadFileWasNamed) {
  host_.open_texture = [](const std::filesystem::path&) -> std::shared_ptr<const TextureImage> {
    throw FileError("cannot read the picture 'a.png': it is empty");
  };
  expect_error("\ngr.texture('a.png')", "scene.lua:2: ", {"'a.png': it is empty"}, ExitCode::file);
}

}  // namespace
}  // namespace rt::lua
