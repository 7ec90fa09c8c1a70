// Scenes that are wrong: one message that a person can act on, the right exit code, no half file.
#include <regex>

#include "program.h"

namespace rt::test {
namespace {

using BadScene = ProgramTest;

struct Case {
  const char* what;
  std::string script;
  const char* says;  ///< must stand in the message
  int exit_code = 1;
};

const std::string render_tail =
    ", 'x.png', 8, 8, {0,0,5}, {0,0,-1}, {0,1,0}, 40, {0.1,0.1,0.1}, {})\n";

const Case cases[] = {
    {"syntax error", "local x = = 3\n", "scene.lua:1:"},
    {"runtime error", "\nlocal x = nil + 1\n", "scene.lua:2:"},
    {"unknown function", "gr.spheer('a')\n", "did you mean 'sphere'"},
    {"unknown method", "gr.sphere('a'):rotat('x', 3)\n", "rotate"},
    {"unknown material key", "gr.material{kd={1,1,1}, shinyness=3}\n", "shininess"},
    {"unknown render option",
     "gr.render(gr.sphere('a'), 'x.png', 8, 8, {0,0,5}, {0,0,-1}, {0,1,0}, 40, {0,0,0}, {}, "
     "{max_deph=3})\n",
     "max_depth"},
    {"wrong type for a name", "gr.sphere(5)\n", "scene.lua:1:"},
    {"wrong type for a colour", "gr.material('red', {0,0,0}, 1)\n", "scene.lua:1:"},
    {"two numbers for a colour", "gr.material({1, 2}, {0,0,0}, 1)\n", "scene.lua:1:"},
    {"negative size",
     "gr.render(gr.sphere('a'), 'x.png', -8, 8, {0,0,5}, {0,0,-1}, {0,1,0}, 40, "
     "{0,0,0}, {})\n",
     "-8"},
    {"fractional size",
     "gr.render(gr.sphere('a'), 'x.png', 8.5, 8, {0,0,5}, {0,0,-1}, {0,1,0}, 40, "
     "{0,0,0}, {})\n",
     "8.5"},
    {"NaN", "gr.sphere('a'):translate(0/0, 0, 0)\n", "scene.lua:1:"},
    {"infinite", "gr.sphere('a'):translate(math.huge, 0, 0)\n", "scene.lua:1:"},
    {"singular scale names the node", "gr.sphere('pancake'):scale(1, 0, 1)\n", "pancake"},
    {"cycle names the node",
     "local a, b = gr.node('alpha'), gr.node('beta')\na:add_child(b)\nb:add_child(a)\n", "alpha"},
    {"zero falloff", "gr.light({1,2,3}, {1,1,1}, {0,0,0})\n", "falloff"},
    {"up parallel to view",
     "gr.render(gr.sphere('a'), 'x.png', 8, 8, {0,0,5}, {0,1,0}, {0,2,0}, 40, {0,0,0}, {})\n",
     "parallel"},
    {"zero view",
     "gr.render(gr.sphere('a'), 'x.png', 8, 8, {0,0,5}, {0,0,0}, {0,1,0}, 40, {0,0,0}, {})\n",
     "view"},
    {"field of view 0",
     "gr.render(gr.sphere('a'), 'x.png', 8, 8, {0,0,5}, {0,0,-1}, {0,1,0}, 0, {0,0,0}, {})\n",
     "field of view"},
    {"field of view 180",
     "gr.render(gr.sphere('a'), 'x.png', 8, 8, {0,0,5}, {0,0,-1}, {0,1,0}, 180, {0,0,0}, {})\n",
     "field of view"},
    {"missing mesh", "gr.mesh('a', 'nowhere.obj')\n", "nowhere.obj", 3},
    {"no picture", "local a = gr.sphere('a')\n", "gr.render"},
    {"render of nothing", "gr.render(nil" + render_tail, "scene.lua:1:"},
    {"bytecode", "\x1bLua", "scene.lua"},
    {"io is not there", "io.open('/etc/passwd')\n", "scene.lua:1:"},
    {"require outside", "require '../evil'\n", "scene.lua:1:"},
};

/// One line with the error; where that names a line of the script, the line and a caret below it.
const std::regex with_excerpt(
    "error: scene\\.lua:[0-9]+:[0-9]+: [^\n]+\n +[0-9]+ \\| [^\n]+\n +\\| *\\^~*\n");
const std::regex without_excerpt("error: (?!scene\\.lua:[0-9])[^\n]+\n");

TEST_F(BadScene, EachGivesOneMessage) {
  for (const Case& c : cases) {
    const Outcome o = run_script(c.script);
    EXPECT_EQ(o.exit_code, c.exit_code) << c.what << ": " << o.err;
    EXPECT_NE(o.err.find(c.says), std::string::npos) << c.what << ": " << o.err;
    EXPECT_TRUE(std::regex_match(o.err, with_excerpt) || std::regex_match(o.err, without_excerpt))
        << c.what << ": " << o.err;
    EXPECT_FALSE(left_a_file()) << c.what;
  }
}

TEST_F(BadScene, AMissingMaterialIsAWarningNotAnError) {
  const Outcome o = run_script("gr.render(gr.sphere('naked')" + render_tail, "-q");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.err.find("warning: "), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("naked"), std::string::npos) << o.err;
}

TEST_F(BadScene, AnEmptyLightListIsLegal) {
  const Outcome o = run_script(sphere_script() + "gr.render(ball" + render_tail, "-q");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_EQ(o.err, "");
}

TEST_F(BadScene, GarbageAsAScriptIsRefused) {
  std::string garbage;
  for (int i = 0; i < 4096; ++i) {
    garbage.push_back(static_cast<char>((i * 7919 + 13) % 251));
  }
  const Outcome o = run_script(garbage);
  EXPECT_EQ(o.exit_code, 1) << o.err;
  std::filesystem::create_directory(folder_ / "folder.lua");
  EXPECT_EQ(run("folder.lua").exit_code, 3);
}

}  // namespace
}  // namespace rt::test
