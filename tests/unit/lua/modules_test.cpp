#include "script_run.h"

namespace rt::lua {
namespace {

using Modules = ScriptTest;

TEST_F(Modules, RequireRunsAFileOnceAndKeepsItsResult) {
  write("shapes.lua", "count = (count or 0) + 1\nreturn {ball = gr.sphere('ball'), name = ...}");
  write("lib/deep.lua", "deep = true");
  run(R"(
    local a, b = require 'shapes', require('shapes')
    assert(a == b and count == 1 and a.name == 'shapes')
    assert(require 'lib.deep' == true and deep)
    assert(require 'string' == string and require 'math' == math))");
}

TEST_F(Modules, DofileRunsEachTimeAndReturnsEverything) {
  write("lib/three.lua", "count = (count or 0) + 1\nreturn 1, nil, 3");
  run(R"(
    local r = table.pack(dofile 'lib/three.lua')
    assert(r.n == 3 and r[1] == 1 and r[3] == 3)
    dofile('lib/three.lua')
    assert(count == 2))");
}

TEST_F(Modules, ErrorsInsideHaveTheModulesLine) {
  write("bad.lua", "\n\ngr.sphere(1)");
  write("worse.lua", "x = = 1");
  expect_error("require 'bad'", "bad.lua:3: gr.sphere: ");
  expect_error("dofile 'worse.lua'", "worse.lua:1: unexpected symbol");
  run("assert(not pcall(require, 'bad'))\n"
      "local ok, text = pcall(require, 'bad')\nassert(text:find('gr.sphere', 1, true), text)");
}

TEST_F(Modules, MissingFilesAreFileErrors) {
  expect_error("\nrequire 'absent'", "scene.lua:2: require: there is no file 'absent.lua' in ", {},
               ExitCode::file);
  expect_error("dofile 'absent.lua'", "scene.lua:1: dofile: there is no file", {}, ExitCode::file);
  expect_error("require(3)", "scene.lua:1: require: expected a module's name (string)");
  expect_error("dofile()", "scene.lua:1: dofile: expected a file name (string)");
}

TEST_F(Modules, ALoopOfRequiresIsAnError) {
  write("a.lua", "require 'b'");
  write("b.lua", "\nrequire 'a'");
  expect_error("require 'a'", "b.lua:2: require: 'a.lua' requires itself");
}

TEST_F(Modules, FilesOutsideTheScriptsFolderAreRefused) {
  const auto outside = folder_ / "outside.lua";
  write("outside.lua", "error('reached')");
  write("inner/scene.lua", "");
  const auto fails = [&](const std::string& text) {
    write("inner/scene.lua", text);
    try {
      run_script(folder_ / "inner/scene.lua", {}, host_);
    } catch (const SceneError& error) {
      return std::string(error.what()).find("lies outside") != std::string::npos;
    } catch (const UserError&) {
    }
    return false;
  };
  std::filesystem::create_symlink(outside, folder_ / "inner/link.lua");
  std::filesystem::create_symlink(folder_, folder_ / "inner/up");
  EXPECT_TRUE(fails("dofile '../outside.lua'"));
  EXPECT_TRUE(fails("dofile '" + outside.string() + "'"));
  EXPECT_TRUE(fails("dofile 'link.lua'"));
  EXPECT_TRUE(fails("dofile 'nothing/../link.lua'"));
  EXPECT_TRUE(fails("dofile 'nothing/../up/outside.lua'"));
  EXPECT_TRUE(fails("require 'link'"));
  EXPECT_TRUE(fails("dofile 'up/outside.lua'"));
  EXPECT_TRUE(fails("require 'up.outside'"));
  EXPECT_TRUE(fails("require '..outside'")) << "dots are folders: //outside.lua is absolute";
}

TEST_F(Modules, BytecodeFilesAreRefused) {
  write("code.lua", "\x1bLua");
  expect_error("require 'code'", "", {"bytecode"});
  expect_error("dofile 'code.lua'", "", {"bytecode"});
}

}  // namespace
}  // namespace rt::lua
