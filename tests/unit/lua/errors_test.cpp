/// How errors travel between the host, Lua and the caller.
#include "script_run.h"

namespace rt::lua {
namespace {

class Errors : public ScriptTest {
 protected:
  const std::string render_ =
      "gr.render(gr.node('n'), 'a.png', 4, 3, {0,0,1}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})";
};

TEST_F(Errors, SyntaxErrorsHaveTheirLine) {
  expect_error("x = 1\ny = = 2", "scene.lua:2: unexpected symbol near '='");
  expect_error("for i = 1, 3 do", "scene.lua:1: 'end' expected");
}

TEST_F(Errors, RuntimeErrorsHaveTheirLine) {
  expect_error("local t\n\nlocal x = t.y", "scene.lua:3: attempt to index a nil value (local 't')");
  expect_error("error('mine')", "scene.lua:1: mine");
  expect_error("error('mine', 0)", "mine");
  expect_error("\nerror({})", "scene.lua:2: the script raised an error that is a table");
  expect_error("error(setmetatable({}, {__tostring = function() return 'told' end}))", "told");
  expect_error("error()", "scene.lua:1: the script raised an error that is a nil");
}

TEST_F(Errors, TheHostsExitCodeSurvives) {
  host_.render = [](const RenderJob&) { throw FileError("cannot write 'a.png'"); };
  expect_error(render_, "scene.lua:1: cannot write 'a.png'", {}, ExitCode::file);
  expect_error("local function f()\n" + render_ + "\nend\nlocal function g() f() end\ng()",
               "scene.lua:2: cannot write 'a.png'", {}, ExitCode::file);
  expect_error("coroutine.wrap(function() " + render_ + " end)()",
               "scene.lua:1: ", {"cannot write"}, ExitCode::file);
  host_.render = [](const RenderJob&) { throw UserError(ExitCode::interrupted, "stopped"); };
  expect_error(render_, "scene.lua:1: stopped", {}, ExitCode::interrupted);
}

TEST_F(Errors, TheLocationIsNotSaidTwice) {
  host_.render = [](const RenderJob& job) { throw SceneError(job.where + ": bad job"); };
  expect_error(render_, "scene.lua:1: bad job");
}

TEST_F(Errors, AnErrorThatIsRaisedAgainKeepsItsCode) {
  host_.render = [](const RenderJob&) { throw FileError("disk full"); };
  expect_error(
      "local ok, text = pcall(function() " + render_ + " end)\nassert(not ok)\nerror(text, 0)",
      "scene.lua:1: disk full", {}, ExitCode::file);
  expect_error("local ok, text = pcall(function() " + render_ + " end)\nerror(text)",
               "scene.lua:2: scene.lua:1: disk full", {}, ExitCode::file);
}

TEST_F(Errors, WhatTheScriptCatchesIsNoErrorOfTheProgram) {
  host_.render = [](const RenderJob&) { throw FileError("disk full"); };
  run("local ok, text = pcall(function() " + render_ + " end)\n" +
      "assert(not ok and type(text) == 'string' and text:find('disk full'))\n"
      "ok, text = pcall(gr.sphere, 3)\n"
      "assert(not ok and text:find('scene.lua:3: gr.sphere: expected a name', 1, true), text)");
  expect_error("pcall(function() " + render_ + " end)\ngr.sphere(3)", "scene.lua:2: gr.sphere: ");
}

TEST_F(Errors, OtherExceptionsOfTheHostAreReported) {
  host_.render = [](const RenderJob&) { throw std::logic_error("oops"); };
  expect_error(render_, "scene.lua:1: internal error: oops");
  host_.render = [](const RenderJob&) { throw std::bad_alloc(); };
  expect_error(render_, "scene.lua:1: not enough memory", {}, ExitCode::limit);
}

TEST_F(Errors, AMissingScriptIsAFileError) {
  for (const auto& path : {folder_ / "absent.lua", folder_}) {
    try {
      run_script(path, {}, host_);
      ADD_FAILURE() << path;
    } catch (const UserError& error) {
      EXPECT_EQ(error.code(), ExitCode::file);
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
    }
  }
}

TEST_F(Errors, PathsAreShownAsTheUserGaveThem) {
  const auto before = std::filesystem::current_path();
  write("scenes/foo.lua", "\n\ngr.sphere()");
  std::filesystem::current_path(folder_);
  std::string text;
  try {
    run_script("scenes/foo.lua", {}, host_);
  } catch (const SceneError& error) {
    text = error.what();
  }
  std::filesystem::current_path(before);
  EXPECT_TRUE(text.starts_with("scenes/foo.lua:3: gr.sphere: ")) << text;
}

TEST_F(Errors, DeepRecursionIsAnOrdinaryError) {
  expect_error("local function f() return 1 + f() end\nf()", "scene.lua:1: stack overflow");
}

TEST_F(Errors, AFirstLineForTheShellAndAByteOrderMarkAreSkipped) {
  expect_error("#!/usr/bin/raytracer\ngr.sphere()", "scene.lua:2: gr.sphere: ");
  expect_error("\xEF\xBB\xBFgr.sphere()", "scene.lua:1: gr.sphere: ");
  run("#");
  run("");
}

TEST_F(Errors, AHostWithoutFunctionsIsEnoughForAScript) {
  host_ = {};
  run("gr.sphere('s', 1)\n" + render_);
}

}  // namespace
}  // namespace rt::lua
