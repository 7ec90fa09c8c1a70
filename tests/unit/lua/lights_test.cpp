#include "script_run.h"

namespace rt::lua {
namespace {

class Lights : public ScriptTest {
 protected:
  Light made(const std::string& expression) {
    run("local l = " + expression +
        "\ngr.render(gr.node('n'), 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {l})");
    return jobs_.back().lights.at(0);
  }
};

TEST_F(Lights, PositionalForm) {
  const Light l = made("gr.light({1, 2, 3}, {0.5, 0.6, 0.7}, {1, 2, 3})");
  EXPECT_EQ(l.position, Vec3(1, 2, 3));
  EXPECT_EQ(l.colour, Rgb(0.5, 0.6, 0.7));
  EXPECT_EQ(l.falloff.c0, 1.0);
  EXPECT_EQ(l.falloff.c1, 2.0);
  EXPECT_EQ(l.falloff.c2, 3.0);
  EXPECT_EQ(l.radius, 0.0);
  EXPECT_FALSE(l.rectangle);
  EXPECT_EQ(without_folder(l.where), "scene.lua:1");
  EXPECT_EQ(made("gr.light({1, 2, 3}, 1, {1, 0, 0}, 0.5)").radius, 0.5);
  EXPECT_EQ(made("gr.light({1, 2, 3}, 1, {1, 0, 0}, nil)").radius, 0.0);
}

TEST_F(Lights, NamedFormInBothSpellings) {
  const Light a =
      made("gr.light{position={1,2,3}, colour={4,5,6}, falloff={0,0,1}, radius=2, visible=true}");
  EXPECT_EQ(a.position, Vec3(1, 2, 3));
  EXPECT_EQ(a.colour, Rgb(4, 5, 6));
  EXPECT_EQ(a.falloff.c2, 1.0);
  EXPECT_EQ(a.radius, 2.0);
  EXPECT_TRUE(a.visible);
  const Light b = made("gr.light{position={1,2,3}, color={4,5,6}, u={1,0,0}, v={0,0,2}}");
  EXPECT_EQ(b.colour, Rgb(4, 5, 6));
  EXPECT_EQ(b.falloff.c0, 1.0);
  EXPECT_EQ(b.falloff.c1, 0.0);
  ASSERT_TRUE(b.rectangle);
  EXPECT_EQ(b.rectangle->u, Vec3(1, 0, 0));
  EXPECT_EQ(b.rectangle->v, Vec3(0, 0, 2));
}

TEST_F(Lights, ZeroFalloffNamesTheLight) {
  expect_error("gr.light({1, 2, 3}, {1, 1, 1}, {0, 0, 0})",
               "scene.lua:1: gr.light: ", {"(falloff)", "{0, 0, 0}", "light at (1, 2, 3)"});
  expect_error("gr.light{falloff={0, 0, 0}, position={4, 5, 6}}",
               "scene.lua:1: gr.light: ", {"'falloff'", "light at (4, 5, 6)"});
  expect_error("gr.light({1, 2, 3}, {1, 1, 1}, {2, -1, 0})", "scene.lua:1: gr.light: ",
               {"not negative", "argument 3 (falloff)", "item 2 is a number (-1)"});
}

TEST_F(Lights, BadValuesAreExplained) {
  expect_error("gr.light{postion={0, 0, 0}}",
               "scene.lua:1: gr.light: ", {"unknown key 'postion'; did you mean 'position'"});
  expect_error("gr.light{colour=1}", "scene.lua:1: gr.light: ", {"'position'", "got nil"});
  expect_error("gr.light({0, 0}, 1, {1, 0, 0})",
               "scene.lua:1: ", {"argument 1 (position)", "item 3"});
  expect_error("gr.light({0, 0, 0}, {-1, 0, 0}, {1, 0, 0})", "scene.lua:1: ", {"(colour)", "(-1)"});
  expect_error("gr.light({0, 0, 0}, {1, 0, 0})", "scene.lua:1: ", {"(falloff), got nothing"});
  expect_error("gr.light({0, 0, 0}, 1, {1, 0, 0}, -1)", "scene.lua:1: ", {"(radius)", "(-1)"});
  expect_error("gr.light{position={0,0,0}, colour=1, color=1}",
               "scene.lua:1: ", {"both 'colour' and 'color'"});
  expect_error("gr.light{position={0,0,0}, colr=1}",
               "scene.lua:1: gr.light: unknown key 'colr'; did you mean 'colour'?");
  expect_error("gr.light{position={0,0,0}, visible=1}",
               "scene.lua:1: ", {"true or false as 'visible'"});
  expect_error("gr.light{position={0,0,0}, u={1,0,0}}", "scene.lua:1: ", {"both edges"});
  expect_error("gr.light{position={0,0,0}, u={1,0,0}, v={2,0,0}}", "scene.lua:1: ", {"no area"});
  expect_error("gr.light{position={0,0,0}, u={1,0,0}, v={0,1,0}, radius=1}",
               "scene.lua:1: ", {"not both"});
}

TEST_F(Lights, AFourthArgumentOfAnotherKindIsIgnored) {
  EXPECT_EQ(made("gr.light({1, 2, 3}, 1, {1, 0, 0}, gr.node('n'), 7)").radius, 0.0);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_NE(warnings_[0].find("argument 4, a node (\"n\"); argument 5, a number (7)"),
            std::string::npos)
      << warnings_[0];
}

}  // namespace
}  // namespace rt::lua
