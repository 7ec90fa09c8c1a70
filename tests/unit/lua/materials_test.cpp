#include "script_run.h"

namespace rt::lua {
namespace {

class Materials : public ScriptTest {
 protected:
  Material made(const std::string& expression) {
    return *instance_of_root("root = gr.sphere('s'):set_material(" + expression + ")").material;
  }
};

TEST_F(Materials, ThreeArgumentsAsInTheCourse) {
  const Material m = made("gr.material({0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, 25)");
  EXPECT_EQ(m.kd, Rgb(0.1, 0.2, 0.3));
  EXPECT_EQ(m.ks, Rgb(0.4, 0.5, 0.6));
  EXPECT_EQ(m.shininess, 25.0);
  EXPECT_EQ(m.reflectivity, Rgb(0.0));
  EXPECT_EQ(m.opacity, 1.0);
}

TEST_F(Materials, SixArguments) {
  const Material m = made("gr.material({1, 1, 1}, {0, 0, 0}, 10, 1.5, 0.25, 0.125)");
  EXPECT_EQ(m.ior, 1.5);
  EXPECT_EQ(m.opacity, 0.25);
  EXPECT_EQ(m.glossiness, 0.125);
}

TEST_F(Materials, NamedForm) {
  const Material m = made(
      "gr.material{kd={1,0,0}, ks={0,1,0}, shininess=7, reflectivity={0,0,1}, ior=1.3, "
      "opacity=0.5, glossiness=0.75, absorption={1,2,3}, emission={4,5,6}}");
  EXPECT_EQ(m.kd, Rgb(1, 0, 0));
  EXPECT_EQ(m.ks, Rgb(0, 1, 0));
  EXPECT_EQ(m.shininess, 7.0);
  EXPECT_EQ(m.reflectivity, Rgb(0, 0, 1));
  EXPECT_EQ(m.ior, 1.3);
  EXPECT_EQ(m.opacity, 0.5);
  EXPECT_EQ(m.glossiness, 0.75);
  EXPECT_EQ(m.absorption, Rgb(1, 2, 3));
  EXPECT_EQ(m.emission, Rgb(4, 5, 6));
}

TEST_F(Materials, OneNumberIsAGreyAndFieldsHaveDefaults) {
  const Material m = made("gr.material{kd=0.3, reflectivity=1}");
  EXPECT_EQ(m.kd, Rgb(0.3));
  EXPECT_EQ(m.reflectivity, Rgb(1.0));
  EXPECT_EQ(m.ks, Material{}.ks);
  EXPECT_EQ(made("gr.material{}").kd, Material{}.kd);
}

TEST_F(Materials, UnknownKeysSuggestTheNearest) {
  expect_error("gr.material{kd=1, shinyness=3}",
               "scene.lua:1: gr.material: unknown key 'shinyness'; did you mean 'shininess'?",
               {"There are: kd, ks, shininess"});
  expect_error("gr.material{kd=1, [2]=3}", "scene.lua:1: gr.material: unknown key '[2]'");
  expect_error("gr.material{kd=1, [true]=3}", "scene.lua:1: gr.material: unknown key '[a boolean");
}

TEST_F(Materials, BadValuesAreExplained) {
  expect_error("gr.material({1, -1, 1}, {0, 0, 0}, 1)",
               "scene.lua:1: gr.material: expected a colour {r, g, b}, not negative as argument 1 "
               "(kd), got a table whose item 2 is a number (-1); try gr.material(");
  expect_error("gr.material({1, 1, 1})", "scene.lua:1: ", {"argument 2 (ks), got nothing"});
  expect_error("gr.material(1, 1)", "scene.lua:1: ", {"argument 3 (shininess), got nothing"});
  expect_error("gr.material(1, 0, -1)", "scene.lua:1: ", {"argument 3 (shininess)", "(-1)"});
  expect_error("gr.material(1, 0, 'shiny')", "scene.lua:1: ", {"a string (\"shiny\")"});
  expect_error("gr.material(1, 0, 1, 0)", "scene.lua:1: ", {"positive number as argument 4 (ior)"});
  expect_error("gr.material(1, 0, 1, 1, 1.5)", "scene.lua:1: ", {"from 0 to 1", "(opacity)"});
  expect_error("gr.material{kd='red'}", "scene.lua:1: ", {"as 'kd', got a string (\"red\")"});
  expect_error("gr.material{glossiness=2}",
               "scene.lua:1: ", {"'glossiness'", "from 0 to 1", "(2)"});
  expect_error("gr.material{emission={0, 0, 0/0}}",
               "scene.lua:1: ", {"'emission'", "item 3", "nan"});
  expect_error("gr.material()", "scene.lua:1: ", {"argument 1 (kd), got nothing"});
  expect_error("gr.material('red')", "scene.lua:1: ", {"argument 1 (kd), got a string (\"red\")"});
}

TEST_F(Materials, ArgumentsOfOtherDialectsAreIgnoredWithOneWarning) {
  const Material m = made("gr.material(1, 0, 1, {0.5, 0.5, 0.5}, nil, 0.5, 'wood', true, 3, 4)");
  EXPECT_EQ(m.ior, Material{}.ior);
  EXPECT_EQ(m.glossiness, 0.5);
  ASSERT_EQ(warnings_.size(), 1u);
  const std::string text = without_folder(warnings_[0]);
  EXPECT_TRUE(
      text.starts_with("scene.lua:1: gr.material: ignored argument 4, a table with 3 items; "
                       "argument 7, a string (\"wood\"); argument 8, a boolean (true); "
                       "argument 9, a number (3); argument 10, a number (4). It takes "))
      << text;
}

}  // namespace
}  // namespace rt::lua
