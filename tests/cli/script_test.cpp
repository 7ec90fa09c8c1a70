// What the program does for those who write scripts.
#include <algorithm>

#include "program.h"

namespace rt::test {
namespace {

using Writing = ProgramTest;

TEST_F(Writing, ErrorsShowTheLineAndTheWord) {
  const struct {
    const char* script;
    const char* shows;
  } cases[] = {
      {"\nlocal m = gr.material{kd = {1, 0, 0}, shinyness = 3}\n",
       "error: scene.lua:2:39: gr.material: unknown key 'shinyness'; did you mean 'shininess'?"},
      {"\nlocal m = gr.material{kd = {1, 0, 0}, shinyness = 3}\n",
       "\n     2 | local m = gr.material{kd = {1, 0, 0}, shinyness = 3}\n"
       "       |                                       ^~~~~~~~~\n"},
      {"gr.sphere('a'):translate(1, 'two', 3)\n",
       "\n     1 | gr.sphere('a'):translate(1, 'two', 3)\n"
       "       |                             ^~~~~\n"},
      {"gr.nh_box('a', {0, 0, 0}, 1) gr.nh_box('b', {0, 0, 0},\n  -4)\n",
       "\n     2 |   -4)\n       |   ^~\n"},
      {"x = 1\nlocal y = x + undefined_name\n",
       "\n     2 | local y = x + undefined_name\n       |               ^~~~~~~~~~~~~~\n"},
      {"gr.spheer('a')\n", "\n     1 | gr.spheer('a')\n       |    ^~~~~~\n"},
      {"local a = gr.sphere('a')\na:rotat('x', 3)\n",
       "\n     2 | a:rotat('x', 3)\n       |   ^~~~~\n"},
      {"\ny = = 2\n",
       "error: scene.lua:2:5: unexpected symbol near '='\n     2 | y = = 2\n       |     ^\n"},
      {"gr.sphere()\n", "\n     1 | gr.sphere()\n       |           ^\n"},
      {"\tgr.sphere(5)\n", "\n     1 |  gr.sphere(5)\n       |            ^\n"},
  };
  for (const auto& c : cases) {
    const Outcome o = run_script(c.script);
    EXPECT_NE(o.err.find(c.shows), std::string::npos) << c.script << o.err;
  }
}

TEST_F(Writing, LongPathsAndLongLinesAreShownWhole) {
  const std::string folder = std::string(40, 'a') + "/" + std::string(40, 'b');
  std::filesystem::create_directories(folder_ / folder);
  write(folder + "/scene.lua", "local t\nlocal x = t.y" + std::string(300, ' ') + "-- end\n");
  const Outcome o = run(folder + "/scene.lua");
  EXPECT_TRUE(o.err.starts_with("error: " + folder + "/scene.lua:2:11: attempt to index")) << o.err;
  EXPECT_LT(o.err.size(), 500u) << o.err;
}

TEST_F(Writing, VerboseShowsTheWayThroughTheFiles) {
  write("part.lua", "local function build()\n  gr.sphere(3)\nend\nbuild()\n");
  const std::string script = "-- a comment\nrequire 'part'\n";
  EXPECT_EQ(run_script(script).err.find("traceback"), std::string::npos);
  const Outcome o = run_script(script, "--verbose");
  EXPECT_TRUE(o.err.starts_with("error: part.lua:2:13: gr.sphere: expected a name")) << o.err;
  EXPECT_NE(o.err.find("stack traceback:"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("part.lua:4:"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("scene.lua:2:"), std::string::npos) << o.err;
}

TEST_F(Writing, ANewSceneRenders) {
  const Outcome made = run("--new first.lua");
  EXPECT_EQ(made.exit_code, 0) << made.err;
  const std::string text = contents(folder_ / "first.lua");
  EXPECT_NE(text.find("raytracer first.lua"), std::string::npos);
  EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 20);
  const Outcome drawn = run("first.lua -q --size 40x30 --samples 4");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(drawn.err, "");
  EXPECT_TRUE(exists("first.png"));
  EXPECT_EQ(run("--new first.lua").exit_code, 3) << "never over a file that is there";
  EXPECT_EQ(contents(folder_ / "first.lua"), text);
  EXPECT_EQ(run("--new missing/first.lua").exit_code, 3);
}

TEST_F(Writing, TransformsPreOrPostMultiply) {
  const std::string script =
      "local ball = gr.sphere('ball'):translate(2, 0, 0):rotate('y', 90)\n"
      "gr.render(ball, 'x.png', 16, 16, {0,0,9}, {0,0,-1}, {0,1,0}, 40, 1, {})\n";
  EXPECT_EQ(run_script(script, "-q -o pre.png").exit_code, 0);
  EXPECT_EQ(run("scene.lua -q -o post.png --transform-order post").exit_code, 0);
  EXPECT_EQ(run("scene.lua -q -o same.png --transform-order pre").exit_code, 0);
  EXPECT_NE(contents(folder_ / "pre.png"), contents(folder_ / "post.png"));
  EXPECT_EQ(contents(folder_ / "pre.png"), contents(folder_ / "same.png"));
  EXPECT_EQ(run("scene.lua --transform-order sideways").exit_code, 2);
}

TEST_F(Writing, AMaterialThatNoNodeHasIsReported) {
  const Outcome o = run_script(
      "local m = gr.material{kd = 1}\nlocal n = gr.material{kd = 0}\n" + sphere_script(), "-q");
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.err,
            "warning: scene.lua:1: the material made here is set on no node (nor are 1 more)\n");
}

TEST_F(Writing, UnknownCallsAreSkippedWhenLenient) {
  const std::string script = "gr.skybox('x')\nlocal k = gr.node('k'):wobble(3)\n" + sphere_script();
  EXPECT_EQ(run_script(script).exit_code, 1);
  const Outcome o = run_script(script, "-q --lenient");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.err.find("warning: scene.lua:1: there is no gr.skybox"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("warning: scene.lua:2: nodes have no method 'wobble'"), std::string::npos);
}

}  // namespace
}  // namespace rt::test
