#include <gtest/gtest.h>

#include <cmath>

#include "rt/scene/error.h"
#include "rt/scene/options.h"
#include "rt/scene/render_job.h"

namespace rt {
namespace {

std::shared_ptr<Node> sphere_node(const std::string& name) {
  auto node = std::make_shared<Node>();
  node->name = name;
  node->shape = std::make_shared<const Shape>(Sphere{});
  return node;
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(Node, TransformsPreMultiply) {
  Node node;
  translate(node, {0, 0, 2});
  rotate(node, 1, 90);
  EXPECT_EQ(node.parent_from_node.point({0, 0, 0}), Vec3(2, 0, 0));
}

TEST(Node, SingularAndNonFiniteTransformsNameTheNode) {
  Node node;
  node.name = "elbow";
  for (const auto& call : {std::function<void()>([&] {
                             scale(node, {1, 0, 1});
                           }),
                           std::function<void()>([&] {
                             translate(node, {NAN, 0, 0});
                           }),
                           std::function<void()>([&] { rotate(node, 0, INFINITY); })}) {
    EXPECT_NE(message_of(call).find("'elbow'"), std::string::npos);
  }
}

TEST(Node, CyclesAreRefusedAndDiamondsAreNot) {
  auto a = sphere_node("a");
  auto b = sphere_node("b");
  auto c = sphere_node("c");
  auto d = sphere_node("d");
  add_child(*a, b);
  add_child(*a, c);
  add_child(*b, d);
  add_child(*c, d);
  EXPECT_THROW(add_child(*d, a), SceneError);
  EXPECT_THROW(add_child(*a, a), SceneError);
  const Flattened flat = flatten(*a);
  EXPECT_EQ(flat.instances.size(), 5u);
  EXPECT_EQ(flat.instances[2].shape, flat.instances[4].shape) << "instances share their shape";
}

TEST(Flatten, MaterialsAreInheritedFromTheNearestAncestor) {
  auto red = std::make_shared<Material>();
  auto blue = std::make_shared<Material>();
  auto root = std::make_shared<Node>();
  auto arm = sphere_node("arm");
  auto hand = sphere_node("hand");
  root->material = red;
  hand->material = blue;
  add_child(*root, arm);
  add_child(*arm, hand);
  const Flattened flat = flatten(*root);
  ASSERT_EQ(flat.instances.size(), 2u);
  EXPECT_EQ(flat.instances[0].material, red);
  EXPECT_EQ(flat.instances[1].material, blue);
  EXPECT_TRUE(flat.warnings.empty());
}

TEST(Flatten, AMissingMaterialGivesADefaultAndOneWarning) {
  auto root = std::make_shared<Node>();
  add_child(*root, sphere_node("one"));
  add_child(*root, sphere_node("two"));
  const Flattened flat = flatten(*root);
  ASSERT_EQ(flat.instances.size(), 2u);
  EXPECT_TRUE(flat.instances[0].material);
  ASSERT_EQ(flat.warnings.size(), 1u);
  EXPECT_NE(flat.warnings[0].find("'one' (and 1 more)"), std::string::npos) << flat.warnings[0];
}

/// A group with a texture over `child`.
std::shared_ptr<Node> textured_group(const std::string& name, std::shared_ptr<Node> child) {
  auto textures = std::make_shared<TextureSet>();
  (*textures)[TextureSlot::kd].texture = std::make_shared<Texture>(Checker{});
  auto group = std::make_shared<Node>();
  group->name = name;
  group->textures = textures;
  if (child) {
    add_child(*group, std::move(child));
  }
  return group;
}

TEST(Flatten, TexturesThatNoShapeTakesAreWarnedOf) {
  const auto material = std::make_shared<Material>();
  const auto painted = [&](const std::string& name) {
    auto node = sphere_node(name);
    node->material = material;
    return node;
  };
  auto root = std::make_shared<Node>();
  root->material = material;
  add_child(*root, textured_group("seen", sphere_node("bare")));
  add_child(*root, textured_group("outer", textured_group("inner", sphere_node("deep"))));
  EXPECT_TRUE(flatten(*root).warnings.empty());

  // Seen in one place is enough for a node that stands in two.
  auto shared = textured_group("shared", nullptr);
  auto shows = textured_group("shows", shared);
  add_child(*root, shared);
  add_child(*root, shows);
  add_child(*shared, sphere_node("in shared"));
  EXPECT_TRUE(flatten(*root).warnings.empty());

  add_child(*root, textured_group("hidden", painted("own")));
  add_child(*root, textured_group("bare", nullptr));
  const Flattened flat = flatten(*root);
  ASSERT_EQ(flat.warnings.size(), 1u);
  EXPECT_TRUE(flat.warnings[0].starts_with(
      "the texture of node 'hidden' covers nothing (nor do those of 1 more): "))
      << flat.warnings[0];
}

TEST(Flatten, TransformsThatUnderflowTogetherNameTheNode) {
  auto root = std::make_shared<Node>();
  auto node = sphere_node("speck");
  scale(*root, Vec3(1e-200));
  scale(*node, Vec3(1e-200));
  add_child(*root, node);
  EXPECT_NE(message_of([&] { flatten(*root); }).find("'speck'"), std::string::npos);
}

TEST(Flatten, LaterEditsDoNotTouchTheSnapshot) {
  auto node = sphere_node("ball");
  const Flattened flat = flatten(*node);
  node->shape = std::make_shared<const Shape>(Box{});
  translate(*node, {1, 0, 0});
  EXPECT_TRUE(std::holds_alternative<Sphere>(*flat.instances[0].shape));
  EXPECT_EQ(flat.instances[0].world_from_model.offset, Vec3(0.0));
}

TEST(Camera, ImpossibleCamerasAreRefused) {
  EXPECT_NO_THROW(check(Camera{}));
  EXPECT_THROW(check({.view = {0, 2, 0}, .up = {0, -3, 0}}), SceneError);
  EXPECT_THROW(check({.view = {0, 0, 0}}), SceneError);
  EXPECT_THROW(check({.up = {0, 0, 0}}), SceneError);
  EXPECT_THROW(check({.eye = {NAN, 0, 0}}), SceneError);
  for (double fov : {0.0, -1.0, 180.0, 1e9, static_cast<double>(NAN)}) {
    EXPECT_THROW(check({.fov = fov}), SceneError) << fov;
  }
  EXPECT_NO_THROW(check({.view = {1e-200, 0, 0}, .up = {0, 1e200, 0}}));
}

TEST(Options, AreSetByNameFromScriptAndCommandLine) {
  RenderOptions o;
  find_option("max-depth")->set(o, OptionValue("3"));
  find_option("samples")->set(o, OptionValue(4.0));
  find_option("encoding")->set(o, OptionValue("raw"));
  find_option("reflection")->set(o, OptionValue(false));
  EXPECT_EQ(o.max_depth, 3);
  EXPECT_EQ(o.samples, 4);
  EXPECT_EQ(o.encoding, Encoding::raw);
  EXPECT_FALSE(o.reflection);
  EXPECT_EQ(find_option("maxdepth"), nullptr);
}

TEST(Options, WrongValuesSayWhatWasExpected) {
  RenderOptions o;
  for (const OptionValue& v :
       {OptionValue("0"), OptionValue(1.5), OptionValue("many"), OptionValue(true),
        OptionValue(static_cast<double>(NAN)), OptionValue("1e99"), OptionValue("4x")}) {
    try {
      find_option("samples")->set(o, v);
      ADD_FAILURE() << "accepted";
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find("expected a whole number"), std::string::npos);
    }
  }
  EXPECT_THROW(find_option("encoding")->set(o, OptionValue("gamma")), std::invalid_argument);
}

TEST(Options, Size) {
  int w = 0;
  int h = 0;
  parse_size("640x480", w, h);
  EXPECT_EQ(w, 640);
  EXPECT_EQ(h, 480);
  for (const char* bad : {"", "640", "x", "640x", "0x5", "-1x5", "640x480x", "1e3x5", "70000x1"}) {
    EXPECT_THROW(parse_size(bad, w, h), std::invalid_argument) << bad;
  }
}

TEST(Options, MisspellingsFindTheirName) {
  const std::string_view known[] = {"max_depth", "samples", "seed"};
  EXPECT_EQ(nearest_name("max_deph", known), "max_depth");
  EXPECT_EQ(nearest_name("sampels", known), "samples");
  EXPECT_EQ(nearest_name("fog", known), "");
}

TEST(Options, SamplesAreFixedOnlyWhereTheUserSaysSo) {
  RenderOptions o;
  EXPECT_EQ(fixed_samples(o), 0);
  o.aa = AntiAliasing::corners;
  EXPECT_EQ(fixed_samples(o), 0);
  o.adaptive = false;
  EXPECT_EQ(fixed_samples(o), 0);
  o.aa = AntiAliasing::adaptive;
  EXPECT_EQ(fixed_samples(o), 16);
  o.adaptive = true;
  o.aa = AntiAliasing::uniform;
  EXPECT_EQ(fixed_samples(o), 16);
  o.samples = 5;
  EXPECT_EQ(fixed_samples(o), 5);
  o.antialiasing = false;
  EXPECT_EQ(fixed_samples(o), 1);
}

}  // namespace
}  // namespace rt
