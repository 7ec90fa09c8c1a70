// Warnings about scenes that will look wrong, and none about scenes that will not.
#include <algorithm>

#include "program.h"

namespace rt::test {
namespace {

using Warned = ProgramTest;

const std::string grey = "local m = gr.material{kd = 0.5}\n";

std::string render(const std::string& node, const std::string& lights, const std::string& ambient,
                   const std::string& eye = "{0, 0, 5}") {
  return "gr.render(" + node + ", 'x.png', 16, 12, " + eye + ", {0, 0, -1}, {0, 1, 0}, 40, " +
         ambient + ", {" + lights + "})\n";
}

const std::string lamp = "gr.light({3, 4, 5}, {1, 1, 1}, {1, 0, 0})";

TEST_F(Warned, OfWhatWillLookWrong) {
  const struct {
    std::string script;
    const char* says;
  } cases[] = {
      {render("gr.node('empty')", lamp, "0.2"), "there is no shape in the scene"},
      {grey + render("gr.sphere('s'):translate(0, 0, 9):set_material(m)", lamp, "0.2"),
       "nothing is in view: from (0, 0, 5) in the direction (0, 0, -1)"},
      {grey + render("gr.sphere('shell'):scale(9):set_material(m)", "", "0.3"),
       "the camera at (0, 0, 5) is inside 'shell'"},
      {grey + render("gr.cube('crate'):translate(-0.5, -0.5, 4.5):set_material(m)", lamp, "0"),
       "is inside 'crate'"},
      {grey + render("gr.sphere('s'):set_material(m)", "", "0"),
       "neither lights nor ambient light"},
      {grey +
           render("gr.sphere('s'):set_material(m)", "gr.light({0, 0, -9}, {1,1,1}, {1,0,0})", "0"),
       "no light reaches what is in view"},
      {grey + render("gr.sphere('bulb'):set_material(m)", "gr.light({0.1, 0, 0}, {1,1,1}, {1,0,0})",
                     "0.2"),
       "the light at (0.1, 0, 0) is inside 'bulb'"},
      {grey +
           "local pair = gr.node('pair'):set_texture(gr.checker(0, 1))\n"
           "pair:add_child(gr.sphere('s'):set_material(m))\n" +
           render("pair", lamp, "0.2"),
       "the texture of node 'pair' (scene.lua:2) covers nothing"},
      {grey +
           "local t = gr.mesh('t', {{-1,-1,0}, {1,-1,0}, {0,1,0}}, {{0,1,2}}):set_material(m)\n"
           "t:set_texture('brick.jpg')\n" +
           render("t", lamp, "0.2"),
       "mesh 't' (scene.lua:2) has no texture coordinates"},
  };
  for (const auto& c : cases) {
    const Outcome o = run_script(c.script, "-q --samples 1");
    EXPECT_EQ(o.exit_code, 0) << c.script << o.err;
    EXPECT_NE(o.err.find(c.says), std::string::npos) << c.script << o.err;
    EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << c.script << o.err;
    EXPECT_TRUE(o.err.starts_with("warning: scene.lua:")) << o.err;
  }
}

TEST_F(Warned, NotOfARoomNorOfALampOfGlass) {
  const std::string cases[] = {
      grey +
          "local room = gr.node('room'):set_material(m)\n"
          "room:add_child(gr.cube('walls'):translate(-0.5, -0.5, -0.5):scale(20))\n"
          "room:add_child(gr.sphere('ball'))\n" +
          render("room", lamp, "0.2"),
      "local glass = gr.material{kd = 0.1, opacity = 0.1, ior = 1.5}\n" +
          render("gr.sphere('bulb'):set_material(glass)",
                 "gr.light({0.1, 0, 0}, {1,1,1}, {1,0,0}), " + lamp, "0.2"),
      grey + render("gr.sphere('s'):set_material(m)", lamp, "0"),
      grey + render("gr.plane('ground'):translate(0, -1, 0):set_material(m)", lamp, "0.2"),
      grey +
          "local pair = gr.node('pair'):set_material(m):set_texture('brick.jpg')\n"
          "pair:add_child(gr.sphere('s'))\n" +
          render("pair", lamp, "0.2"),
      grey +
          "local t = gr.mesh('t', {{-1,-1,0}, {1,-1,0}, {0,1,0}}, {{0,1,2}}):set_material(m)\n"
          "t:set_texture(gr.checker(0.2, 1))\n" +
          render("t", lamp, "0.2"),
      grey + render("gr.sphere('s'):set_material(m)",
                    "gr.light{position = {0, 0, 5}, colour = 1, radius = 2, visible = true}",
                    "0.2"),
  };
  for (const std::string& script : cases) {
    const Outcome o = run_script(script, "-q --samples 4");
    EXPECT_EQ(o.exit_code, 0) << script << o.err;
    EXPECT_EQ(o.err, "") << script;
  }
}

TEST_F(Warned, NotOfTheScenesThatComeWithTheProgram) {
  for (const auto& entry : std::filesystem::directory_iterator(RT_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() == ".lua") {
      const Outcome o =
          run(entry.path().string() + " -q --samples 1 --size 40x30 -o " + folder_.string() + "/");
      EXPECT_EQ(o.exit_code, 0) << entry.path() << o.err;
      EXPECT_EQ(o.err, "") << entry.path();
    }
  }
}

}  // namespace
}  // namespace rt::test
