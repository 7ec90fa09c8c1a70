// node:set_texture and node:perlin_noise.
#include "script_run.h"

namespace rt::lua {
namespace {

class Surfaces : public ScriptTest {
 protected:
  /// Runs a script that may use `ball`, and gives the textures of that node.
  const TextureSet& textures(const std::string& calls) {
    run("local root = gr.node('root') local ball = gr.sphere('ball') root:add_child(ball)\n" +
        calls +
        "\ngr.render{scene = root, file = 'a.png', size = {4, 4}, camera = {eye = {0, 0, 5}, "
        "look_at = {0, 0, 0}}}");
    return *jobs_.back().instances.at(0).textures;
  }
  const NoiseTexture& noise(const std::string& fields, TextureSlot slot = TextureSlot::kd) {
    return std::get<NoiseTexture>(*textures("ball:perlin_noise" + fields)[slot].texture);
  }
};

TEST_F(Surfaces, EachSlotHasItsTexture) {
  const TextureSet& set = textures(
      "local c = gr.checker(1, 0)\n"
      "ball:set_texture(c):set_texture(c, 'ks'):set_texture(c, 'opacity')"
      ":perlin_noise{on = 'bump', strength = 0.25}");
  for (const TextureSlot slot : {TextureSlot::kd, TextureSlot::ks, TextureSlot::opacity}) {
    EXPECT_TRUE(std::holds_alternative<Checker>(*set[slot].texture));
  }
  EXPECT_TRUE(std::holds_alternative<NoiseTexture>(*set[TextureSlot::bump].texture));
  EXPECT_EQ(set[TextureSlot::bump].strength, 0.25);
  EXPECT_EQ(set[TextureSlot::normal].texture, nullptr);
}

TEST_F(Surfaces, ALaterPictureDoesNotSeeEarlierTextures) {
  const std::string render =
      " gr.render{scene = b, file = 'a.png', size = {4, 4}, camera = {eye = {0, 0, 5}, "
      "look_at = {0, 0, 0}}}";
  run("local b = gr.sphere('b')" + render + " b:perlin_noise{}" + render +
      " b:perlin_noise{on = 'bump'}" + render);
  EXPECT_EQ(jobs_[0].instances[0].textures, nullptr);
  EXPECT_EQ((*jobs_[1].instances[0].textures)[TextureSlot::bump].texture, nullptr);
  EXPECT_NE((*jobs_[2].instances[0].textures)[TextureSlot::bump].texture, nullptr);
}

TEST_F(Surfaces, ChildrenAddToWhatTheyInherit) {
  run("local a = gr.node('a'):set_material(gr.material(1, 0, 1)):set_texture(gr.checker(1, 0))\n"
      "local b = gr.sphere('b'):perlin_noise{on = 'bump'}\n"
      "local c = gr.sphere('c'):set_material(gr.material(0, 0, 1))\n"
      "a:add_child(b) a:add_child(c)\n"
      "gr.render{scene = a, file = 'a.png', size = {4, 4}, camera = {eye = {0, 0, 5}, "
      "look_at = {0, 0, 0}}}");
  const auto& b = *jobs_[0].instances[0].textures;
  EXPECT_NE(b[TextureSlot::kd].texture, nullptr);
  EXPECT_NE(b[TextureSlot::bump].texture, nullptr);
  EXPECT_EQ(jobs_[0].instances[1].textures, nullptr);  // its own material comes without
}

TEST_F(Surfaces, NoiseReadsItsFields) {
  const NoiseTexture& n = noise(
      "{kind = 'wood', seed = 7, octaves = {{scale = 4, weight = 2}, {8, 0.5}, {scale = 16}}, "
      "ramp = {{0, {1, 0, 0}}, {0.5, 0.25}, {at = 1, colour = {0, 0, 1}}, {at = 2, color = 1}}}");
  EXPECT_EQ(n.kind, NoiseKind::wood);
  ASSERT_EQ(n.octaves.size(), 3u);
  EXPECT_EQ(n.octaves[0].frequency, 4);
  EXPECT_EQ(n.octaves[0].weight, 2);
  EXPECT_EQ(n.octaves[1].frequency, 8);
  EXPECT_EQ(n.octaves[2].weight, 1);
  ASSERT_EQ(n.ramp.size(), 4u);
  EXPECT_EQ(n.ramp[1].at, 0.5);
  EXPECT_EQ(n.ramp[1].colour, Rgb(0.25));
  EXPECT_EQ(n.ramp[2].colour, Rgb(0, 0, 1));
  EXPECT_EQ(n.ramp[3].colour, Rgb(1));
  EXPECT_EQ(n.noise->value({0.3, 0.4, 0.5}), Noise(7).value({0.3, 0.4, 0.5}));
}

TEST_F(Surfaces, NoiseIsPerlinsAtAnyCoordinateUnlessSeeded) {
  // noise(3.14, 42, 7) of the specification, by one octave between black and white: the value and
  // its distance to 1/2, near, negative, beyond 2^31 (where it repeats with period 256), tiny.
  const NoiseTexture n = noise("{octaves = {{scale = 1, weight = 1}}}");
  const auto at = [&](const Vec3& p) { return 2 * colour(n, p, Vec3(0.0), Vec3(0.0)).r - 1; };
  EXPECT_NEAR(at({3.14, 42, 7}), 0.13691995878400012, 1e-15);
  EXPECT_NEAR(at({-256 + 3.14, 42, 7}), 0.13691995878400012, 1e-13);
  EXPECT_NEAR(at({3.14, 42 + 0x1p40, 7 - 0x1p35}), 0.13691995878400012, 1e-15);
  EXPECT_EQ(at({0x1p60, 1e300, -1e200}), 0);
  EXPECT_LT(std::abs(at({1e-300, -1e-17, 0})), 1e-15);
  EXPECT_NE(
      at({3.14, 42, 7}),
      2 * colour(noise("{octaves = {{1}}, seed = 1}"), {3.14, 42, 7}, Vec3(0.0), Vec3(0.0)).r - 1);
}

TEST_F(Surfaces, BumpsAddUpWhereTold) {
  const TextureSet& set = textures(
      "ball:perlin_noise{on = 'bump', strength = 1}:perlin_noise{on = 'bump', strength = 2}"
      ":perlin_noise{on = 'bump', strength = 3, add = true}");
  const TextureSet::Entry& top = set[TextureSlot::bump];
  EXPECT_EQ(top.strength, 3);
  ASSERT_NE(top.under, nullptr);
  EXPECT_EQ(top.under->strength, 2);
  EXPECT_EQ(top.under->under, nullptr);
}

TEST_F(Surfaces, MistakesAreNamed) {
  const auto text = [&](const std::string& call) {
    return failure("local n = gr.sphere('n') " + call).text;
  };
  const auto expect = [&](const std::string& call, const std::string& part) {
    EXPECT_NE(text(call).find(part), std::string::npos) << text(call);
    EXPECT_NE(text(call).find("scene.lua:1"), std::string::npos) << text(call);
  };
  expect("n:set_texture(gr.checker(1, 0), 'bumb')", "'bump'");
  expect("n:set_texture(gr.checker(1, 0), 'bump')", "no slopes");
  expect("n:set_texture(gr.checker(1, 0), 'normal')", "only a picture");
  expect("n:set_texture(gr.checker(1, 0), 'ks', 2)", "strength");
  expect("n:perlin_noise{on = 'normal'}", "only a picture");
  expect("n:perlin_noise{kind = 'marbel'}", "did you mean 'marble'");
  expect("n:perlin_noise{octaves = {}}", "a list of octaves");
  expect("n:perlin_noise{octaves = {1, 2}}", "octaves[1]");
  expect("n:perlin_noise{octaves = {{scale = 0}}}", "a positive number");
  expect("n:perlin_noise{octaves = {{weight = 1}}}", "scale");
  expect("n:perlin_noise{octaves = {{scale = 4, wieght = 1}}}",
         "unknown key 'wieght' in octaves[1]; did you mean 'weight'");
  expect("n:perlin_noise{octaves = {{4, scale = 3}}}", "octaves[1] has 'scale' twice");
  expect("n:perlin_noise{ramp = {{1, 0}, {0, 1}}}", "rising order");
  expect("n:perlin_noise{ramp = {{at = 0, colour = 1, x = 3}}}", "unknown key 'x' in ramp[1]");
  expect("n:perlin_noise{ramp = {{1, 0.5, 7, 8}}}", "unknown key '[3]' in ramp[1]");
  expect("n:perlin_noise{ramp = {{at = 0, color = 1, colour = 1}}}", "both 'colour' and 'color'");
  expect("n:perlin_noise{ramp = {{0, 0}}, low = 1}", "not both");
  expect("n:perlin_noise{seed = -1}", "whole number");
  expect("n:perlin_noise{strenght = 1}", "did you mean 'strength'");
  expect("n:perlin_noise(3)", "a table");
  expect("n:perlin_noise{add = true}", "only bumps add up");
  expect("for i = 1, 99 do n:perlin_noise{on = 'bump', add = true} end", "at most 64");
}

}  // namespace
}  // namespace rt::lua
