// --explain: what a scene needs, in words.
#include <filesystem>

#include "program.h"

namespace rt::test {
namespace {

class Explained : public ProgramTest {
 protected:
  std::string explained(const std::string& script, const std::string& options = "") {
    const Outcome o = run_script(script, "--explain " + options);
    EXPECT_EQ(o.exit_code, 0) << o.err;
    EXPECT_FALSE(left_a_file()) << "--explain renders nothing";
    return o.out;
  }
  static bool says(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
  }
};

const char* const plain = R"(
local scene = gr.node("scene")
local ball = gr.sphere("ball")
scene:add_child(ball)
ball:set_material(gr.material({0.8, 0.2, 0.2}, {0, 0, 0}, 10))
gr.render(scene, "ball.png", 64, 48, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.2},
          {gr.light({3, 4, 5}, {1, 1, 1}, {1, 0, 0})})
)";

TEST_F(Explained, APlainSceneIsSaidToNeedLittle) {
  const std::string text = explained(plain);
  EXPECT_TRUE(says(text, "1 shape (1 sphere), 1 light, 64 x 48 pixels")) << text;
  EXPECT_TRUE(says(text, "1 box in a list")) << text;
  EXPECT_TRUE(says(text,
                   "Left out, and costing nothing: random decisions, soft shadows, "
                   "refraction, transparent shadows, absorption, mirrors, gloss, motion, a "
                   "lens, textures and noise"))
      << text;
  // The ball's outline, of radius 5 tan(asin(1/5)) at the distance 5, covers 19% of the picture;
  // from nine tenths of that the light stands above the surface: one ray and 0.17 shadow rays.
  EXPECT_TRUE(says(text, "To expect: 1.2 rays")) << text;
}

TEST_F(Explained, WhatIsAskedForIsSaid) {
  EXPECT_TRUE(says(explained(plain, "--samples 9"), "9 samples a pixel"));
  EXPECT_TRUE(says(explained(plain, "--accel grid"), "uniform grid"));
  EXPECT_TRUE(says(explained(plain, "--accel bvh"), "hierarchy"));
  const char* const many = R"(
local scene = gr.node("scene")
for i = 1, 200 do scene:add_child(gr.nh_sphere("s", {i, 0, 0}, 0.4)) end
gr.render(scene, "many.png", 64, 48, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 40, {1, 1, 1}, {})
)";
  EXPECT_TRUE(says(explained(many), "200 boxes in a hierarchy"));
  EXPECT_TRUE(says(explained(many, "--accel list"), "200 boxes in a list"));
  EXPECT_TRUE(says(explained(plain, "--aa corners"), "classic scheme"));
}

TEST_F(Explained, EveryFeatureThatAppearsIsNoLongerLeftOut) {
  const std::string text = explained(R"(
local scene = gr.node("scene")
local function ball(x, material)
  local b = gr.nh_sphere("ball", {x, 0, 0}, 0.5)
  b:set_material(material)
  scene:add_child(b)
  return b
end
ball(-2, gr.material{kd = {0, 0, 0}, ior = 1.5, opacity = 0, absorption = {1, 0, 0}})
ball(-1, gr.material{kd = {0, 0, 0}, reflectivity = {1, 1, 1}, glossiness = 0.2})
ball(0, gr.material{kd = {1, 1, 1}}):motion{from = {translate = {0, 0, 0}}, to = {translate = {0, 1, 0}}}
ball(1, gr.material{kd = {1, 1, 1}}):set_texture(gr.checker({1, 1, 1}, {0, 0, 0}, 0.1))
gr.render{scene = scene, file = "ball.png", size = {64, 48},
          camera = {eye = {0, 0, 6}, view = {0, 0, -1}, fov = 40, aperture = 0.1, focus = 6},
          lights = {gr.light{position = {3, 4, 5}, colour = {1, 1, 1}, radius = 0.5}}}
)");
  for (const char* word :
       {"soft shadows", "glass", "absorption", "mirrors", "gloss", "motion", "lens", "textures"}) {
    EXPECT_TRUE(says(text, std::string("\n  ") + word)) << word << "\n" << text;
  }
  EXPECT_FALSE(says(text, "random decisions")) << text;
}

}  // namespace
}  // namespace rt::test
